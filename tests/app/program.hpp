#pragma once
// The real program, started in a folder of its own.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <utility>
#include <vector>

#include "write/text_file.hpp"

namespace carom::test {

struct Outcome {
  int status = -1;  ///< exit status; -signal if it was killed
  std::string out, err;
};

class Program {
 public:
  Program(const Folder& folder, const std::vector<std::string>& words, const std::string& out = "stdout.txt")
      : folder_(folder), out_(out) {
    std::vector<std::string> command{CAROM_PROGRAM};
    command.insert(command.end(), words.begin(), words.end());
    std::vector<char*> pointers;
    for (std::string& word : command) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::string out_file = out.front() == '/' ? out : folder.file(out), err_file = folder.file("stderr.txt");
    const std::string start = folder.path().string();
    process_ = fork();
    if (process_ == 0) {
      const bool ready =
          chdir(start.c_str()) == 0 && redirect(out_file, STDOUT_FILENO) && redirect(err_file, STDERR_FILENO);
      if (ready) execv(CAROM_PROGRAM, pointers.data());
      _exit(127);
    }
  }
  ~Program() {
    if (process_ > 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const { kill(process_, signal); }

  Outcome wait() {
    int state = 0;
    waitpid(std::exchange(process_, -1), &state, 0);
    Outcome outcome{WIFEXITED(state) ? WEXITSTATUS(state) : -WTERMSIG(state), "", folder_.read("stderr.txt")};
    if (out_.front() != '/') outcome.out = folder_.read(out_);
    return outcome;
  }

 private:
  static bool redirect(const std::string& file, int to) {
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    return descriptor >= 0 && dup2(descriptor, to) >= 0;
  }

  const Folder& folder_;
  std::string out_;
  pid_t process_ = -1;
};

inline Outcome carom(const Folder& folder, const std::vector<std::string>& words, const std::string& out = "stdout.txt") {
  return Program(folder, words, out).wait();
}

/// Two elastic balls of radius 1/2 that meet head-on at t = 1, x = 4.5 and 5.5, and the faces of the box [0, 10] at t = 5.
inline std::string head_on(int dimension, const std::string& more = "") {
  const std::string zeros = dimension == 3 ? ", 0, 0" : dimension == 2 ? ", 0" : "";
  const std::string fives = dimension == 3 ? ", 5, 5" : dimension == 2 ? ", 5" : "";
  const std::string tens = dimension == 3 ? ", 10, 10" : dimension == 2 ? ", 10" : "";
  return "title = \"Head-on\"\ndimension = " + std::to_string(dimension) + "\n[space]\nkind = \"box\"\nlower = [0" + zeros +
         "]\nupper = [10" + tens + "]\n[[ball]]\nname = \"left\"\nposition = [3.5" + fives + "]\nvelocity = [1" + zeros +
         "]\n[[ball]]\nposition = [6.5" + fives + "]\nvelocity = [-1" + zeros + "]\n[run]\nuntil = 6\n" + more;
}

}  // namespace carom::test
