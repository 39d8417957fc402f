#include "plot_command.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include <CLI/Validators.hpp>
#include <fmt/core.h>

#include "carom/core/error.hpp"
#include "carom/write/output_file.hpp"
#include "figures.hpp"
#include "output_folder.hpp"

namespace carom::app {

namespace fs = std::filesystem;

namespace {

constexpr int not_found = 127;

/// Runs gnuplot on a script in its folder; its exit status.
int gnuplot(const std::string& folder, const std::string& script) {
  const pid_t process = fork();
  if (process == 0) {
    if (chdir(folder.c_str()) == 0) execlp("gnuplot", "gnuplot", script.c_str(), static_cast<char*>(nullptr));
    _exit(not_found);
  }
  int state = 0;
  if (process < 0 || waitpid(process, &state, 0) < 0) return not_found;
  return WIFEXITED(state) ? WEXITSTATUS(state) : 1;
}

void require_gnuplot() {
  const pid_t process = fork();
  if (process == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    if (nowhere >= 0 && dup2(nowhere, STDOUT_FILENO) >= 0) execlp("gnuplot", "gnuplot", "--version", static_cast<char*>(nullptr));
    _exit(not_found);
  }
  int state = 0;
  if (process > 0 && waitpid(process, &state, 0) > 0 && WIFEXITED(state) && WEXITSTATUS(state) == 0) return;
  throw InputError(Problem{"", 0, "there is no gnuplot here", "it draws the figures", "Install it (Debian: apt-get install gnuplot-nox)"});
}

std::string terminal(const std::string& format, const std::string& name) {
  const char* device = format == "png" ? "pngcairo size 900,600 font 'sans,12' background '#ffffff'"
                                       : "svg size 900,600 font 'sans,14' background '#ffffff'";
  return fmt::format("set encoding utf8\nset terminal {}\nset output '{}.{}'\n", device, name, format);
}

}  // namespace

CLI::App* add_plot_command(CLI::App& program, PlotOptions& options) {
  CLI::App* command = program.add_subcommand("plot", "Draws the results in a folder: energy, collisions, speeds, every table");
  command->add_option("DIR", options.folder, "Folder that carom run --out has filled")->required();
  command->add_option("--format", options.format, "svg or png. DEFAULT: svg")->check(CLI::IsMember({"svg", "png"}));
  command->add_option("--out", options.out, "Folder for the figures. DEFAULT: DIR/plots")->type_name("DIR");
  command->footer(
      "Example:\n  carom run scene.toml --out results && carom plot results\n\n"
      "Beside each figure stands its gnuplot script, data included, to be changed and run again.");
  return command;
}

ExitStatus plot(const PlotOptions& options, const Console& console) {
  require_gnuplot();
  const Figures figures = figures_in(options.folder);
  if (figures.list.empty()) {
    std::string why;
    for (const std::string& sentence : figures.missing) why += (why.empty() ? "" : "; ") + sentence;
    throw InputError(Problem{"", 0, "nothing to draw in \"" + options.folder + "\"", why, "Give the folder of carom run --out"});
  }
  const fs::path folder = options.out.empty() ? fs::path(options.folder) / "plots" : fs::path(options.out);
  make_folder(folder);
  for (const Figure& figure : figures.list) {
    const std::string script = figure.name + ".gp";
    OutputFile file((folder / script).string());
    file.line() += terminal(options.format, figure.name) + figure.script;
    file.close();
    const fs::path image = folder / (figure.name + "." + options.format);
    if (gnuplot(folder.string(), script) != 0)
      throw OutputError(fmt::format("gnuplot could not draw \"{}\". Its message is above; the script is {}.", image.string(), script));
    console.out << fmt::format("Wrote {}\n", image.string());
  }
  for (const std::string& sentence : figures.missing) console.err << "carom: not drawn: " << sentence << ".\n";
  return ExitStatus::done;
}

}  // namespace carom::app
