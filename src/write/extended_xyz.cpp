#include "carom/write/extended_xyz.hpp"

#include <algorithm>
#include <array>

#include "carom/write/number_text.hpp"

namespace carom {

namespace {

constexpr std::array<std::string_view, 118> elements{
    "H",  "He", "Li", "Be", "B",  "C",  "N",  "O",  "F",  "Ne", "Na", "Mg", "Al", "Si", "P",  "S",  "Cl", "Ar", "K",  "Ca",
    "Sc", "Ti", "V",  "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga", "Ge", "As", "Se", "Br", "Kr", "Rb", "Sr", "Y",  "Zr",
    "Nb", "Mo", "Tc", "Ru", "Rh", "Pd", "Ag", "Cd", "In", "Sn", "Sb", "Te", "I",  "Xe", "Cs", "Ba", "La", "Ce", "Pr", "Nd",
    "Pm", "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er", "Tm", "Yb", "Lu", "Hf", "Ta", "W",  "Re", "Os", "Ir", "Pt", "Au", "Hg",
    "Tl", "Pb", "Bi", "Po", "At", "Rn", "Fr", "Ra", "Ac", "Th", "Pa", "U",  "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm",
    "Md", "No", "Lr", "Rf", "Db", "Sg", "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og"};

double largest_diameter(const TrajectoryFrame& frame) {
  double radius = 0.0;
  for (const BallState& ball : frame.balls) radius = std::max(radius, ball.radius.value);
  return radius > 0 ? 2 * radius : 1.0;
}

}  // namespace

ExtendedXyz::ExtendedXyz(std::string path, TrajectoryHead head) : file_(std::move(path)), head_(std::move(head)) {}

void ExtendedXyz::append_space(const TrajectoryFrame& frame) {
  std::string& line = file_.line();
  const auto dimension = static_cast<std::size_t>(head_.dimension);
  if (thickness_ == 0.0) thickness_ = largest_diameter(frame);
  if (head_.space != SpaceKind::open) {
    std::string lattice, origin;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool inside = k < dimension;
      lattice += k > 0 ? " " : "";
      for (std::size_t l = 0; l < 3; ++l) {
        lattice += l > 0 ? " " : "";
        append_number(lattice, l != k ? 0.0 : inside ? head_.upper[k] - head_.lower[k] : thickness_);
      }
      origin += k > 0 ? " " : "";
      append_number(origin, inside ? head_.lower[k] : -0.5 * thickness_);
    }
    line += "Lattice=\"" + lattice + "\" Origin=\"" + origin + "\" ";
  }
  line += "pbc=\"";
  for (std::size_t k = 0; k < 3; ++k) {
    line += k > 0 ? " " : "";
    line += head_.space == SpaceKind::periodic && k < dimension ? 'T' : 'F';
  }
  line += "\" Properties=species:S:1:pos:R:3";
  if (head_.velocities) line += ":velo:R:3";
  if (head_.radii) line += ":radius:R:1";
  line += ":mass:R:1:id:I:1";
  if (head_.space == SpaceKind::periodic) line += ":map_shift:I:3";
}

std::string_view ExtendedXyz::species(const BallState& ball) {
  const double radius = head_.growing ? first_radius_.try_emplace(ball.index, ball.radius).first->second : ball.radius.value;
  const std::size_t number = species_.try_emplace({radius, ball.mass.value}, species_.size()).first->second;
  return number < elements.size() ? elements[number] : "X";
}

void ExtendedXyz::append_ball(const BallState& ball) {
  std::string& line = file_.line();
  const auto append_vector = [&line](const auto& components, const auto& zero) {
    for (std::size_t k = 0; k < 3; ++k) {
      line += ' ';
      append_number(line, k < components.size() ? components[k] : zero);
    }
  };
  line += species(ball);
  append_vector(ball.position, Number(0.0));
  if (head_.velocities) append_vector(ball.velocity, Number(0.0));
  if (head_.radii) {
    line += ' ';
    append_number(line, ball.radius);
  }
  line += ' ';
  append_number(line, ball.mass);
  line += ' ';
  append_number(line, std::int64_t{ball.index});
  if (head_.space == SpaceKind::periodic) append_vector(ball.image, std::int64_t{0});
  file_.end_line();
}

void ExtendedXyz::write(const TrajectoryFrame& frame) {
  std::string& line = file_.line();
  append_number(line, static_cast<std::int64_t>(frame.balls.size()));
  file_.end_line();
  append_space(frame);
  line += " Time=";
  append_number(line, frame.time);
  line += " dimension=";
  append_number(line, std::int64_t{head_.dimension});
  file_.end_line();
  for (const BallState& ball : frame.balls) append_ball(ball);
}

void ExtendedXyz::finish(const Ending&) { file_.close(); }

}  // namespace carom
