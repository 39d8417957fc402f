// A system as text: the head of a certificate.

#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "carom/certify/system.hpp"

namespace carom::certify {

namespace {

void put(std::ostream& out, const Vector& v, int dimension) {
  for (int k = 0; k < dimension; ++k) out << ' ' << v[static_cast<std::size_t>(k)].str();
}

class Line {
 public:
  explicit Line(const std::string& text) : in_(text) {}

  std::string word() {
    std::string w;
    if (!(in_ >> w)) throw std::invalid_argument("a line of the certificate's head is too short");
    return w;
  }
  Rational number() {
    const std::string w = word();
    const std::size_t slash = w.find('/');
    using boost::multiprecision::cpp_int;
    try {
      const cpp_int n(w.substr(0, slash)), d(slash == std::string::npos ? "1" : w.substr(slash + 1));
      if (d > 0) return Rational(n, d);
    } catch (const std::runtime_error&) {
    }
    throw std::invalid_argument("\"" + w + "\" in the certificate's head is no number");
  }
  int whole(int least, int most) {
    const Rational n = number();
    if (denominator(n) != 1 || n < least || n > most) throw std::invalid_argument("a count in the certificate's head is out of range");
    return static_cast<int>(numerator(n));
  }
  Vector vector(int dimension) {
    Vector v;
    for (int k = 0; k < dimension; ++k) v[static_cast<std::size_t>(k)] = number();
    return v;
  }

 private:
  std::istringstream in_;
};

constexpr int most = 1'000'000;
constexpr const char* piece_names[] = {"plane", "sphere", "edge", "vertex"};

PieceKind piece_kind(const std::string& name) {
  for (std::size_t k = 0; k < std::size(piece_names); ++k)
    if (name == piece_names[k]) return static_cast<PieceKind>(k);
  throw std::invalid_argument("a piece of a wall is neither plane, sphere, edge nor vertex");
}

void read_line(System& s, const std::string& key, Line& line) {
  if (key == "dimension") {
    s.dimension = line.whole(1, 3);
  } else if (key == "start") {
    s.start = line.number();
  } else if (key == "acceleration") {
    s.acceleration = line.vector(s.dimension);
  } else if (key == "period") {
    s.period = line.vector(s.dimension);
  } else if (key == "wall") {
    s.walls.push_back(line.word());
  } else if (key == "ball") {
    SystemBall b;
    b.position = line.vector(s.dimension);
    b.velocity = line.vector(s.dimension);
    b.radius = line.number();
    if (const std::string mass = line.word(); mass != "inf") b.mass = Line(mass).number();
    b.fixed = line.whole(0, 1) == 1;
    b.material = static_cast<std::uint32_t>(line.whole(0, most));
    s.balls.push_back(b);
  } else if (key == "piece") {
    Piece p;
    p.kind = piece_kind(line.word());
    p.wall = static_cast<std::uint32_t>(line.whole(0, most));
    p.feature = line.whole(0, most);
    p.point = line.vector(s.dimension);
    p.direction = line.vector(s.dimension);
    p.velocity = line.vector(s.dimension);
    p.radius = line.number();
    p.inside = line.whole(0, 1) == 1;
    s.pieces.push_back(p);
  } else if (key == "restitution") {
    std::vector<Rational> row(static_cast<std::size_t>(line.whole(1, most)));
    for (Rational& e : row) e = line.number();
    s.restitution.push_back(row);
  } else if (key == "at_wall") {
    std::vector<Rational> row(static_cast<std::size_t>(line.whole(0, most)));
    for (Rational& e : row) e = line.number();
    s.at_wall.push_back(row);
  } else {
    throw std::invalid_argument("\"" + key + "\" in the certificate's head has no meaning");
  }
}

void judge(const System& s) {
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
  };
  require(!s.restitution.empty() && s.restitution.size() == s.at_wall.size(), "restitution tables are missing");
  for (const auto& row : s.restitution) {
    require(row.size() == s.restitution.size(), "the restitution table is not square");
    for (const Rational& e : row) require(e >= 0 && e <= 1, "a restitution is not from 0 to 1");
  }
  for (const auto& row : s.at_wall) {
    require(row.size() == s.walls.size(), "the restitution at a wall is missing");
    for (const Rational& e : row) require(e >= 0 && e <= 1, "a restitution is not from 0 to 1");
  }
  for (const SystemBall& b : s.balls) {
    require(b.material < s.restitution.size(), "a ball is of no material");
    require(b.radius >= 0 && (!b.mass || *b.mass > 0), "a radius or a mass is negative");
  }
  for (const Piece& p : s.pieces) {
    require(p.wall < s.walls.size(), "a piece is of no wall");
    const bool flat = p.kind == PieceKind::plane || p.kind == PieceKind::edge;
    require(!flat || !is_zero(p.direction), "a flat piece has no direction");
    require(s.dimension == 2 || p.kind == PieceKind::plane || p.kind == PieceKind::sphere, "edges are of the plane");
  }
  if (s.period)
    for (int k = 0; k < s.dimension; ++k) require((*s.period)[static_cast<std::size_t>(k)] > 0, "a period is not positive");
}

}  // namespace

void write_system(std::ostream& out, const System& s) {
  const int d = s.dimension;
  out << "# dimension " << d << "\n# start " << s.start.str() << '\n';
  if (s.accelerated()) put(out << "# acceleration", s.acceleration, d), out << '\n';
  if (s.period) put(out << "# period", *s.period, d), out << '\n';
  for (const SystemBall& b : s.balls) {
    put(out << "# ball", b.position, d);
    put(out, b.velocity, d);
    out << ' ' << b.radius.str() << ' ' << (b.mass ? b.mass->str() : "inf") << ' ' << b.fixed << ' ' << b.material << '\n';
  }
  for (const std::string& w : s.walls) out << "# wall " << w << '\n';
  for (const Piece& p : s.pieces) {
    out << "# piece " << piece_names[static_cast<std::size_t>(p.kind)] << ' ' << p.wall << ' ' << p.feature;
    put(out, p.point, d);
    put(out, p.direction, d);
    put(out, p.velocity, d);
    out << ' ' << p.radius.str() << ' ' << p.inside << '\n';
  }
  const auto table = [&](const char* key, const std::vector<std::vector<Rational>>& rows) {
    for (const auto& row : rows) {
      out << "# " << key << ' ' << row.size();
      for (const Rational& e : row) out << ' ' << e.str();
      out << '\n';
    }
  };
  table("restitution", s.restitution);
  table("at_wall", s.at_wall);
}

System read_system(std::istream& in) {
  System s;
  while (in.peek() == '#') {
    std::string text;
    std::getline(in, text);
    Line line(text.substr(1));
    const std::string key = line.word();
    if (key == "end_of_system") break;
    read_line(s, key, line);
  }
  judge(s);
  return s;
}

}  // namespace carom::certify
