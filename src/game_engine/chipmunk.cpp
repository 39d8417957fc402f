// Scenes in Chipmunk 7: discs that do not rotate, walls of thick and thin segments and discs.

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include <fcntl.h>
#include <unistd.h>

#include <chipmunk/chipmunk.h>
#include <fmt/format.h>

#include "adapters.hpp"
#include "engine_stepper.hpp"

namespace carom::game_engine {

namespace {

cpVect vec(const Point& x) { return cpv(x[0], x[1]); }
Point point(const cpVect& x) { return {x.x, x.y, 0.0}; }

/// A library that was compiled with its checks, as Debian's is, says so on standard output when it makes its first space.
/// That is where the program's result goes.
void make_first_space() {
  std::fflush(stdout);
  const int output = dup(STDOUT_FILENO), nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  cpSpaceFree(cpSpaceNew());
  std::fflush(stdout);
  dup2(output, STDOUT_FILENO);
  close(output);
  close(nowhere);
}
cpSpace* new_space() {
  [[maybe_unused]] static const bool quiet = (make_first_space(), true);
  return cpSpaceNew();
}

struct FreeSpace {
  void operator()(cpSpace* space) const { cpSpaceFree(space); }
};
struct FreeBody {
  void operator()(cpBody* body) const { cpBodyFree(body); }
};
struct FreeShape {
  void operator()(cpShape* shape) const { cpShapeFree(shape); }
};

class Chipmunk final : public EngineStepper {
 public:
  Chipmunk(Layout layout, const GameEngineOptions& options)
      : EngineStepper(std::move(layout), options.dt, RunEnd::silence), space_(new_space()) {
    cpSpaceSetGravity(space_.get(), vec(layout_.acceleration));
    parties_.reserve(layout_.bodies.size() + layout_.pieces.size());  // shapes hold their addresses
    for (std::size_t i = 0; i < layout_.bodies.size(); ++i) add_ball(i);
    for (const Piece& piece : layout_.pieces) add_piece(piece);
    cpCollisionHandler* handler = cpSpaceAddDefaultCollisionHandler(space_.get());
    handler->userData = this;
    handler->preSolveFunc = before;
    handler->postSolveFunc = after;
  }
  ~Chipmunk() override {
    for (auto& shape : shapes_) cpSpaceRemoveShape(space_.get(), shape.get());
    for (auto& body : bodies_) cpSpaceRemoveBody(space_.get(), body.get());
  }
  Chipmunk(const Chipmunk&) = delete;
  Chipmunk& operator=(const Chipmunk&) = delete;

 private:
  void advance() override {
    for (std::size_t i = 0; i < layout_.bodies.size(); ++i)
      if (layout_.bodies[i].kind == BodyKind::driven) cpBodySetVelocity(bodies_[i].get(), vec(driven_velocity(i)));
    cpSpaceStep(space_.get(), dt_);
  }
  [[nodiscard]] Point position(std::size_t i) const override { return point(cpBodyGetPosition(bodies_[i].get())); }
  [[nodiscard]] Point velocity(std::size_t i) const override { return point(cpBodyGetVelocity(bodies_[i].get())); }

  cpBody* add_body(cpBody* body, const Point& position, const Point& velocity) {
    bodies_.emplace_back(body);
    cpBodySetPosition(body, vec(position));
    if (cpBodyGetType(body) != CP_BODY_TYPE_STATIC) cpBodySetVelocity(body, vec(velocity));
    return cpSpaceAddBody(space_.get(), body);
  }
  void add_shape(cpShape* shape) {
    shapes_.emplace_back(shape);
    cpShapeSetUserData(shape, &parties_.back());
    cpSpaceAddShape(space_.get(), shape);
  }

  void add_ball(std::size_t i) {
    const Body& ball = layout_.bodies[i];
    cpBody* body = ball.kind == BodyKind::dynamic  ? cpBodyNew(ball.mass, std::numeric_limits<cpFloat>::infinity())
                   : ball.kind == BodyKind::driven ? cpBodyNewKinematic()
                                                   : cpBodyNewStatic();
    add_body(body, ball.position, ball.velocity);
    parties_.push_back({nullptr, static_cast<std::uint32_t>(i)});
    add_shape(cpCircleShapeNew(body, ball.radius, cpvzero));
  }

  /// A half space is the front of a segment that is as thick as the largest ball; a segment of the scene has no thickness.
  void add_piece(const Piece& piece) {
    const bool moves = norm(piece.velocity) > 0;
    cpBody* body = add_body(moves ? cpBodyNewKinematic() : cpBodyNewStatic(), {}, piece.velocity);
    parties_.push_back({&piece, 0});
    if (piece.kind == PieceKind::half_space) {
      const double thickness = layout_.largest_radius;
      const Point middle = along(piece.point, -thickness, piece.normal), line{-piece.normal[1], piece.normal[0], 0.0};
      add_shape(cpSegmentShapeNew(body, vec(along(middle, -piece.half_length, line)),
                                  vec(along(middle, piece.half_length, line)), thickness));
    } else if (piece.kind == PieceKind::segment) {
      add_shape(cpSegmentShapeNew(body, vec(piece.point), vec(piece.to), 0.0));
    } else if (piece.kind == PieceKind::disc) {
      add_shape(cpCircleShapeNew(body, piece.radius, vec(piece.point)));
    } else {
      add_ring(piece, body);
    }
  }

  /// Each edge is as thick as the largest ball, and set back by that, as a half space is.
  void add_ring(const Piece& piece, cpBody* body) {
    const int n = ring_edges(piece.radius, chipmunk_ring_depth);
    const double thickness = layout_.largest_radius;
    const double corner = piece.radius + thickness / std::cos(std::numbers::pi / n);
    const auto at = [&](int k) {
      const double angle = 2 * std::numbers::pi * k / n;
      return vec(along(piece.point, corner, {std::cos(angle), std::sin(angle), 0.0}));
    };
    for (int k = 0; k < n; ++k) {
      cpShape* edge = cpSegmentShapeNew(body, at(k), at(k + 1), thickness);
      cpSegmentShapeSetNeighbors(edge, at(k - 1), at(k + 2));
      add_shape(edge);
    }
  }

  struct Pair {
    const Party &a, &b;
    ContactKey key;
  };
  static Pair pair(cpArbiter* arbiter) {
    cpShape *first = nullptr, *second = nullptr;
    cpArbiterGetShapes(arbiter, &first, &second);
    if (static_cast<Party*>(cpShapeGetUserData(first))->piece != nullptr) std::swap(first, second);
    const Party &a = *static_cast<Party*>(cpShapeGetUserData(first)), &b = *static_cast<Party*>(cpShapeGetUserData(second));
    return {a, b,
            contact_key(a, b, point(cpBodyGetPosition(cpShapeGetBody(first))),
                        point(cpBodyGetPosition(cpShapeGetBody(second))))};
  }
  static cpBool before(cpArbiter* arbiter, cpSpace*, cpDataPointer data) {
    Chipmunk& self = *static_cast<Chipmunk*>(data);
    const Pair p = pair(arbiter);
    cpArbiterSetRestitution(arbiter, self.layout_.restitution_of(p.a, p.b));
    self.runs_.touch(p.key, -cpArbiterGetDepth(arbiter, 0), 0.0);
    return cpTrue;
  }
  static void after(cpArbiter* arbiter, cpSpace*, cpDataPointer data) {
    Chipmunk& self = *static_cast<Chipmunk*>(data);
    self.runs_.touch(pair(arbiter).key, 0.0, cpvlength(cpArbiterTotalImpulse(arbiter)));
  }

  std::vector<Party> parties_{};
  std::unique_ptr<cpSpace, FreeSpace> space_;
  std::vector<std::unique_ptr<cpBody, FreeBody>> bodies_{};  // the balls, then the walls
  std::vector<std::unique_ptr<cpShape, FreeShape>> shapes_{};
};

}  // namespace

std::unique_ptr<Stepper> make_chipmunk(Layout layout, const GameEngineOptions& options) {
  return std::make_unique<Chipmunk>(std::move(layout), options);
}

std::string chipmunk_version() { return fmt::format("{}.{}.{}", CP_VERSION_MAJOR, CP_VERSION_MINOR, CP_VERSION_RELEASE); }

}  // namespace carom::game_engine
