#include "carom/write/events_csv.hpp"

#include <utility>

#include <fmt/core.h>

#include "carom/write/number_text.hpp"
#include "csv_comments.hpp"

namespace carom {

EventsCsv::EventsCsv(std::string path, const Simulation& simulation, const std::string& title)
    : file_(std::move(path)), dimension_(simulation.dimension()) {
  for (std::uint32_t w = 0; w < simulation.wall_count(); ++w) wall_labels_.push_back(simulation.wall_label(w));
  write_head_comments(file_, "event log", simulation, title);
  std::string& line = file_.line();
  line += "time,epoch,offset,kind,ball,partner,feature";
  for (const char* prefix : {"", "i", "v", "p", "pi", "pv"}) append_columns(line, prefix, dimension_);
  line += ",impulse,tie";
  file_.end_line();
}

void EventsCsv::write(const Collision& c) {
  const bool pair = c.kind == EventKind::ball_ball;
  std::string& line = file_.line();
  append_digits(c.time, c.digits ? &c.digits->time : nullptr);
  line += ',';
  append_number(line, c.epoch);
  line += ',';
  append_digits(c.offset, c.digits ? &c.digits->offset : nullptr);
  line += pair ? ",ball_ball," : ",ball_wall,";
  append_number(line, std::int64_t{c.ball.number});
  line += ',';
  if (pair) {
    append_number(line, std::int64_t{c.partner.number});
  } else {
    line += wall_labels_.at(c.partner.number);
  }
  line += ',';
  append_number(line, std::int64_t{c.feature});
  append_party(c.ball, c.digits ? &c.digits->ball : nullptr);
  if (pair) {
    append_party(c.partner, c.digits ? &c.digits->partner : nullptr);
  } else {
    line.append(3 * static_cast<std::size_t>(dimension_), ',');
  }
  line += ',';
  append_digits(c.impulse, c.digits ? &c.digits->impulse : nullptr);
  line += c.tie ? ",1" : ",0";
  file_.end_line();
  ++written_;
}

void EventsCsv::append_digits(double x, const std::string* digits) {
  if (digits != nullptr) {
    file_.line() += *digits;
  } else {
    append_number(file_.line(), x);
  }
}

void EventsCsv::append_party(const Collision::Party& party, const CollisionDigits::Party* digits) {
  std::string& line = file_.line();
  const auto append = [&](const std::array<double, 3>& components, const std::array<std::string, 3>* texts) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) {
      line += ',';
      append_digits(components[k], texts != nullptr ? &(*texts)[k] : nullptr);
    }
  };
  append(party.position, digits != nullptr ? &digits->position : nullptr);
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) {
    line += ',';
    append_number(line, party.image[k]);
  }
  append(party.velocity_after, digits != nullptr ? &digits->velocity : nullptr);
}

void EventsCsv::finish(Stop stopped_by) {
  file_.line() += fmt::format("# end: {}, {} events", word(stopped_by), written_);
  file_.end_line();
  file_.close();
}

}  // namespace carom
