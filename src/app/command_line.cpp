#include "command_line.hpp"

#include <algorithm>
#include <exception>
#include <sstream>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "carom/core/error.hpp"
#include "carom/write/output_file.hpp"
#include "command_tree.hpp"
#include "completion.hpp"
#include "manual.hpp"
#include "scene/words.hpp"
#include "shell_commands.hpp"

namespace carom::app {

namespace {

class Parser {
 public:
  Parser() : program_("Exact event-driven dynamics of hard balls", "carom") {
    program_.set_version_flag("--version", "carom " CAROM_VERSION);
    program_.footer("Example:\n  carom new break_shot && carom run break_shot.toml\n\nEvery command has --help.");
    run_command_ = add_run_command(program_, run_);
    check_command_ = add_check_command(program_, check_);
    certify_command_ = add_certify_command(program_, certify_);
    compare_command_ = add_compare_command(program_, compare_);
    convert_command_ = add_convert_command(program_, convert_);
    explain_command_ = add_explain_command(program_, explain_);
    new_command_ = add_new_command(program_, new_);
    bench_command_ = add_bench_command(program_, bench_);
    view_command_ = add_view_command(program_, view_);
    plot_command_ = add_plot_command(program_, plot_);
    sweep_command_ = add_sweep_command(program_, sweep_);
    orbit_command_ = add_orbit_command(program_, orbit_);
    completion_command_ = add_completion_command(program_, completion_);
    man_command_ = add_man_command(program_);
  }

  Command parse(const std::vector<std::string>& words) {
    if (words.empty()) return Answer{ExitStatus::done, program_.help()};
    if (!words.front().starts_with('-') && !known(words.front())) return refuse(words.front());
    try {
      program_.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // it takes them from the back
    } catch (const CLI::ParseError& error) {
      return answer(error);
    }
    if (run_command_->parsed()) return run_;
    if (check_command_->parsed()) return check_;
    if (certify_command_->parsed()) return certify_;
    if (compare_command_->parsed()) return compare_;
    if (convert_command_->parsed()) return convert_;
    if (explain_command_->parsed()) return explain_;
    if (new_command_->parsed()) return new_;
    if (bench_command_->parsed()) return bench_;
    if (view_command_->parsed()) return view_;
    if (plot_command_->parsed()) return plot_;
    if (sweep_command_->parsed()) return sweep_;
    if (orbit_command_->parsed()) return orbit_;
    if (completion_command_->parsed()) return Answer{ExitStatus::done, completion_script(command_tree(program_), completion_.shell)};
    if (man_command_->parsed()) return Answer{ExitStatus::done, manual_page(command_tree(program_))};
    return Answer{ExitStatus::wrong_input, "carom: a command is missing. See carom --help\n"};
  }

 private:
  [[nodiscard]] std::vector<const CLI::App*> commands() const {
    return program_.get_subcommands([](const CLI::App*) { return true; });
  }

  [[nodiscard]] bool known(const std::string& word) const {
    const auto list = commands();
    return std::any_of(list.begin(), list.end(), [&](const CLI::App* command) { return command->get_name() == word; });
  }

  [[nodiscard]] Answer refuse(const std::string& word) const {
    const auto list = commands();
    std::vector<std::string> names;
    for (const CLI::App* command : list) names.push_back(command->get_name());
    const std::string hint = scene_text::suggestion(word, {names.begin(), names.end()});
    return {ExitStatus::wrong_input, "carom: there is no command " + scene_text::in_quotes(word) + ". " + hint + " See carom --help\n"};
  }

  [[nodiscard]] Answer answer(const CLI::ParseError& error) const {
    if (error.get_exit_code() == 0) {  // help or the version was asked for
      std::ostringstream out, err;
      static_cast<void>(program_.exit(error, out, err));
      return {ExitStatus::done, out.str()};
    }
    std::string name = "carom";
    for (const CLI::App* command : program_.get_subcommands()) name += " " + command->get_name();
    return {ExitStatus::wrong_input, name + ": " + error.what() + ". See " + name + " --help\n"};
  }

  CLI::App program_;
  RunOptions run_;
  CheckOptions check_;
  CertifyOptions certify_;
  CompareOptions compare_;
  ConvertOptions convert_;
  ExplainOptions explain_;
  NewOptions new_;
  BenchOptions bench_;
  ViewOptions view_;
  PlotOptions plot_;
  SweepOptions sweep_;
  OrbitOptions orbit_;
  CompletionOptions completion_;
  CLI::App *run_command_, *check_command_, *compare_command_, *convert_command_, *explain_command_, *new_command_, *bench_command_,
      *certify_command_, *view_command_, *plot_command_, *sweep_command_, *orbit_command_, *completion_command_, *man_command_;
};

ExitStatus carry_out(const Answer& answer, const Console& console) {
  (answer.status == ExitStatus::done ? console.out : console.err) << answer.text;
  return answer.status;
}
ExitStatus carry_out(const RunOptions& options, const Console& console) { return run(options, console); }
ExitStatus carry_out(const CheckOptions& options, const Console& console) { return check(options, console); }
ExitStatus carry_out(const CertifyOptions& options, const Console& console) { return certify(options, console); }
ExitStatus carry_out(const CompareOptions& options, const Console& console) { return compare(options, console); }
ExitStatus carry_out(const ConvertOptions& options, const Console& console) { return convert(options, console); }
ExitStatus carry_out(const ExplainOptions& options, const Console& console) { return explain(options, console); }
ExitStatus carry_out(const NewOptions& options, const Console& console) { return new_scene(options, console); }
ExitStatus carry_out(const BenchOptions& options, const Console& console) { return bench(options, console); }
ExitStatus carry_out(const ViewOptions& options, const Console& console) { return view(options, console); }
ExitStatus carry_out(const PlotOptions& options, const Console& console) { return plot(options, console); }
ExitStatus carry_out(const SweepOptions& options, const Console& console) { return sweep(options, console); }
ExitStatus carry_out(const OrbitOptions& options, const Console& console) { return orbit(options, console); }

ExitStatus carry_out_any(const Command& command, const Console& console) {
  const ExitStatus status = std::visit([&](const auto& c) { return carry_out(c, console); }, command);
  console.out.flush();
  if (!console.out) throw OutputError("cannot write to standard output. Is the disk full, or its reader gone?");
  return status;
}

}  // namespace

Command parse(const std::vector<std::string>& words) { return Parser().parse(words); }

ExitStatus perform(const Command& command, const Console& console) {
  try {
    return carry_out_any(command, console);
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems())
      console.err << (problem.file.empty() ? "carom: " : "") << problem.text() << '\n';
    return ExitStatus::wrong_input;
  } catch (const OutputError& error) {
    console.err << "carom: " << error.what() << '\n';
    return ExitStatus::stopped;
  } catch (const std::exception& error) {
    console.err << "carom: this is a bug in carom: " << error.what() << ". Please report it, with the scene and the command.\n";
    return ExitStatus::bug;
  }
}

}  // namespace carom::app
