#include "convert_command.hpp"

#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "carom/core/error.hpp"
#include "carom/write/frame_reader.hpp"
#include "carom/write/output_file.hpp"
#include "carom/write/scene_toml.hpp"
#include "carom/write/trajectory.hpp"

namespace carom::app {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(std::string what, std::string why, std::string hint) {
  throw InputError(Problem{"", 0, std::move(what), std::move(why), std::move(hint)});
}

/// The file to write.
std::string target_of(const ConvertOptions& o) {
  if (!o.out.empty()) return o.out;
  if (o.to.find('.') != std::string::npos) return o.to;
  if (o.to.empty() && !o.file.ends_with(".sph") && !o.file.ends_with(".xyz"))
    refuse("it is not said what to make of \"" + o.file + "\"", "there are several possibilities", "Add --to csv, xyz, h5 or toml");
  return fs::path(o.file).replace_extension(o.to.empty() ? "toml" : o.to).string();
}

bool is_scene(const std::string& path) { return path.ends_with(".toml"); }

void check_target(const ConvertOptions& o, const std::string& target) {
  std::error_code ignored;
  if (!is_scene(target)) require_built(target);
  if (fs::equivalent(o.file, target, ignored))
    refuse("\"" + target + "\" is the file that is read", "it would be overwritten", "Choose another name with --out FILE");
  if (is_scene(target) && fs::exists(target, ignored))
    refuse("\"" + target + "\" is there already", "carom convert overwrites no scene", "Choose another name with --out FILE");
}

/// The number of the frame that is asked for.
std::int64_t chosen(const ConvertOptions& o, const Survey& s) {
  const std::int64_t frame = o.frame.value_or(-1);
  const std::int64_t number = frame < 0 ? s.frames + frame : frame;
  if (number < 0 || number >= s.frames)
    refuse(fmt::format("--frame {}", frame), fmt::format("\"{}\" has {} frames", o.file, s.frames),
           "Frames are numbered from 0; -1 is the last");
  return number;
}

void give_radii(const ConvertOptions& o, TrajectoryHead& head, TrajectoryFrame& frame) {
  if (head.radii || !o.radius) return;
  for (BallState& ball : frame.balls) ball.radius = *o.radius;
}

/// Hands on the frames that are asked for.
template <class Take>
void for_frames(const ConvertOptions& o, const Survey& s, bool one, Take take) {
  const std::int64_t only = one ? chosen(o, s) : -1;
  const std::unique_ptr<FrameReader> reader = read_frames(o.file);
  TrajectoryHead head = s.head;
  TrajectoryFrame frame;
  for (std::int64_t k = 0; reader->next(frame); ++k) {
    if (only >= 0 && k != only) continue;
    give_radii(o, head, frame);
    take(frame);
    if (k == only) return;
  }
}

void write_scene(const ConvertOptions& o, const Survey& s, const std::string& target) {
  if (!s.head.radii && !o.radius)
    refuse("\"" + o.file + "\" has no radii", "a scene needs them", "Give all balls one with --radius R");
  for_frames(o, s, true, [&](const TrajectoryFrame& frame) {
    OutputFile file(target);
    file.line() += scene_toml(s.head, frame, {fs::path(o.file).filename().string(), o.temperature, o.seed});
    file.close();
  });
}

void write_frames(const ConvertOptions& o, const Survey& s, const std::string& target) {
  TrajectoryHead head = s.head;
  head.radii = head.radii || o.radius.has_value();
  Provenance provenance;
  provenance.converted_from = fs::path(o.file).filename().string();
  const std::unique_ptr<Trajectory> trajectory = begin_trajectory(target, head, provenance);
  for_frames(o, s, o.frame.has_value(), [&](const TrajectoryFrame& frame) { trajectory->write(frame); });
  trajectory->finish({s.stopped_by, std::nullopt});
}

}  // namespace

CLI::App* add_convert_command(CLI::App& program, ConvertOptions& options) {
  CLI::App* command = program.add_subcommand("convert", "Turns trajectories into one another, and snapshots into scenes");
  command->add_option("FILE", options.file, "Trajectory (.h5, .xyz, .csv) or snapshot (.xyz, .sph)")->required();
  command->add_option("--to", options.to, "Format csv, xyz, h5 or toml (a scene), or a file name. DEFAULT: toml of .xyz and .sph")
      ->type_name("FORMAT");
  command->add_option("-o,--out", options.out, "File to write. DEFAULT: FILE with the format's ending")->type_name("OUT");
  command->add_option("--frame", options.frame, "This frame alone, from 0, -1 the last. DEFAULT: all; of a scene the last")
      ->type_name("N");
  command->add_option("--radius", options.radius, "Radius of all balls, where the file has none")->type_name("R");
  command->add_option("--temperature", options.temperature, "k_B T of a scene's velocities, where the file has none. DEFAULT: 1")
      ->type_name("T");
  command->add_option("--seed", options.seed, "Seed of those. DEFAULT: 1")->type_name("S");
  command->footer(
      "Example:\n  carom convert trajectory.h5 --to xyz\n  carom convert snapshot.sph -o start.toml && carom run start.toml");
  return command;
}

ExitStatus convert(const ConvertOptions& options, const Console& console) {
  const std::string target = target_of(options);
  check_target(options, target);
  const Survey s = survey(options.file);
  if (s.frames == 0) refuse("\"" + options.file + "\" has no frames", "there is nothing to convert", "Check the name");
  if (options.radius && !(*options.radius > 0)) refuse("--radius", "it is above 0", "");
  if (!(options.temperature > 0)) refuse("--temperature", "it is above 0", "");
  if (s.cut_off)
    console.err << fmt::format("carom: \"{}\" was cut off: what there is of it is converted.\n", options.file);
  if (is_scene(target)) {
    write_scene(options, s, target);
    console.out << fmt::format("Wrote {}. Run it: carom run {}\n", target, target);
  } else {
    write_frames(options, s, target);
    const std::int64_t frames = options.frame ? 1 : s.frames;
    console.out << fmt::format("Wrote {}: {} {} of {} balls.\n", target, frames, frames == 1 ? "frame" : "frames", s.head.balls);
  }
  return ExitStatus::done;
}

}  // namespace carom::app
