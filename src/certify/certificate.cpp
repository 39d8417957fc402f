#include "certificate.hpp"

#include <algorithm>
#include <charconv>
#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "carom/core/precision.hpp"

namespace carom::certify {

namespace {

constexpr const char* title = "# carom certificate 1";
constexpr const char* axes[] = {",turns_x", ",turns_y", ",turns_z"};

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream in(row);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

template <class Whole>
Whole whole(const std::string& text) {
  Whole n{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc{} || end != text.data() + text.size()) throw std::invalid_argument("\"" + text + "\" in the certificate is no count");
  return n;
}

std::string line_of(std::istream& in) {
  std::string line;
  if (!std::getline(in, line)) throw std::invalid_argument("the certificate ends too early");
  return line;
}

}  // namespace

void write_head(std::ostream& out, const System& system, int digits) {
  out << title << '\n';
  write_system(out, system);
  out << "# end_of_system\n# digits " << digits << "\nevent,kind,ball,partner,feature";
  for (int k = 0; k < system.dimension; ++k) out << axes[k];
  out << ",lower,upper\n";
}

void write_event(std::ostream& out, const System& system, std::int64_t number, const Claim& c) {
  const bool wall = c.kind == MeetingKind::ball_wall;
  out << number << (wall ? ",ball_wall," : ",ball_ball,") << c.ball << ',';
  if (wall) {
    out << system.walls[c.partner];
  } else {
    out << c.partner;
  }
  out << ',' << c.feature;
  for (int k = 0; k < system.dimension; ++k) out << ',' << c.period[static_cast<std::size_t>(k)];
  out << ',' << c.lower << ',' << c.upper << '\n';
}

void write_end(std::ostream& out, const std::optional<Rational>& until) {
  out << "# end " << (until ? until->str() : "event") << '\n';
  out.flush();
}

CertificateReader::CertificateReader(std::istream& in) : in_(in) {
  if (line_of(in_) != title) throw std::invalid_argument("this is no certificate of carom");
  system_ = read_system(in_);
  const std::string digits = line_of(in_), prefix = "# digits ";
  if (!digits.starts_with(prefix)) throw std::invalid_argument("the certificate does not say in how many digits it was made");
  digits_ = whole<int>(digits.substr(prefix.size()));
  if (digits_ < Precision::least_digits || digits_ > Precision::most_digits)
    throw std::invalid_argument("the certificate was made in a number of digits that is out of range");
  if (!line_of(in_).starts_with("event,")) throw std::invalid_argument("the certificate has no table");
}

std::optional<Claim> CertificateReader::next() {
  const std::string line = line_of(in_);
  if (const std::string end = "# end "; line.starts_with(end)) {
    const std::string until = line.substr(end.size());
    if (until != "event") {
      const std::size_t slash = until.find('/');
      using boost::multiprecision::cpp_int;
      try {
        until_ = Rational(cpp_int(until.substr(0, slash)), cpp_int(slash == std::string::npos ? "1" : until.substr(slash + 1)));
      } catch (const std::exception&) {
        throw std::invalid_argument("\"" + until + "\" at the certificate's end is no time");
      }
    }
    return std::nullopt;
  }
  const std::vector<std::string> cells = cells_of(line);
  const auto d = static_cast<std::size_t>(system_.dimension);
  if (cells.size() != 7 + d) throw std::invalid_argument("row " + std::to_string(row_ + 1) + " of the certificate is not complete");
  if (whole<std::int64_t>(cells[0]) != ++row_) throw std::invalid_argument("row " + std::to_string(row_) + " of the certificate has another number");
  Claim c;
  c.ball = whole<std::uint32_t>(cells[2]);
  if (cells[1] == "ball_wall") {
    c.kind = MeetingKind::ball_wall;
    const auto wall = std::find(system_.walls.begin(), system_.walls.end(), cells[3]);
    c.partner = static_cast<std::uint32_t>(wall - system_.walls.begin());
  } else if (cells[1] == "ball_ball") {
    c.partner = whole<std::uint32_t>(cells[3]);
  } else {
    throw std::invalid_argument("row " + std::to_string(row_) + " of the certificate is of no kind");
  }
  c.feature = whole<std::int32_t>(cells[4]);
  for (std::size_t k = 0; k < d; ++k) c.period[k] = whole<std::int64_t>(cells[5 + k]);
  c.lower = cells[5 + d];
  c.upper = cells[6 + d];
  c.enclosed = true;
  return c;
}

}  // namespace carom::certify
