// Scenes in Box2D 2.4 [Catto2005]: discs that do not rotate, walls of edges, chains and discs.

#include <cmath>
#include <numbers>

#include <box2d/box2d.h>
#include <fmt/format.h>

#include "adapters.hpp"
#include "engine_stepper.hpp"

namespace carom::game_engine {

namespace {

constexpr int velocity_iterations = 8, position_iterations = 3;  // as b2_world.h recommends
constexpr double skin = static_cast<double>(b2_polygonRadius);   // of every edge and chain

b2Vec2 vec(const Point& x) { return {static_cast<float>(x[0]), static_cast<float>(x[1])}; }
Point point(const b2Vec2& x) { return {static_cast<double>(x.x), static_cast<double>(x.y), 0.0}; }
Point left_of(const Point& u) { return {-u[1], u[0], 0.0}; }

class Box2D final : public EngineStepper, private b2ContactListener {
 public:
  Box2D(Layout layout, const GameEngineOptions& options)
      : EngineStepper(std::move(layout), options.dt, RunEnd::word), world_(vec(layout_.acceleration)) {
    world_.SetAllowSleeping(!options.awake);
    if (options.threshold) threshold_ = std::ldexp(*options.threshold, layout_.length);
    parties_.reserve(layout_.bodies.size() + layout_.pieces.size());  // fixtures hold their addresses
    for (std::size_t i = 0; i < layout_.bodies.size(); ++i) add_ball(i, options.continuous);
    for (const Piece& piece : layout_.pieces) add_piece(piece);
    world_.SetContactListener(this);
  }

 private:
  void advance() override {
    for (std::size_t i = 0; i < balls_.size(); ++i)
      if (layout_.bodies[i].kind == BodyKind::driven) balls_[i]->SetLinearVelocity(vec(driven_velocity(i)));
    world_.Step(static_cast<float>(dt_), velocity_iterations, position_iterations);
  }
  [[nodiscard]] Point position(std::size_t i) const override { return point(balls_[i]->GetPosition()); }
  [[nodiscard]] Point velocity(std::size_t i) const override { return point(balls_[i]->GetLinearVelocity()); }

  void add_ball(std::size_t i, bool continuous) {
    const Body& body = layout_.bodies[i];
    b2BodyDef def;
    def.type = body.kind == BodyKind::dynamic  ? b2_dynamicBody
               : body.kind == BodyKind::driven ? b2_kinematicBody
                                               : b2_staticBody;
    def.position = vec(body.position);
    def.linearVelocity = vec(body.velocity);
    def.fixedRotation = true;
    def.bullet = continuous;
    b2Body* made = world_.CreateBody(&def);
    b2CircleShape disc;
    disc.m_radius = static_cast<float>(body.radius);
    parties_.push_back({nullptr, static_cast<std::uint32_t>(i)});
    add_fixture(made, disc);
    if (body.kind == BodyKind::dynamic) {
      const b2MassData mass{static_cast<float>(body.mass), b2Vec2_zero, 0.0F};
      made->SetMassData(&mass);
    }
    balls_.push_back(made);
  }

  void add_fixture(b2Body* body, const b2Shape& shape) {
    b2FixtureDef def;
    def.shape = &shape;
    def.density = 1.0F;
    def.friction = 0.0F;
    if (threshold_) def.restitutionThreshold = static_cast<float>(*threshold_);
    def.userData.pointer = reinterpret_cast<uintptr_t>(&parties_.back());
    body->CreateFixture(&def);
  }

  /// The skin of an edge stands out from it: where balls are on one side only, the edge is set back by as much.
  void add_piece(const Piece& piece) {
    b2BodyDef def;
    def.type = norm(piece.velocity) > 0 ? b2_kinematicBody : b2_staticBody;
    def.linearVelocity = vec(piece.velocity);
    b2Body* body = world_.CreateBody(&def);
    parties_.push_back({&piece, 0});
    if (piece.kind == PieceKind::half_space) {
      const Point middle = along(piece.point, -skin, piece.normal), line = left_of(piece.normal);
      b2EdgeShape edge;
      edge.SetTwoSided(vec(along(middle, -piece.half_length, line)), vec(along(middle, piece.half_length, line)));
      add_fixture(body, edge);
    } else if (piece.kind == PieceKind::segment) {
      b2EdgeShape edge;
      edge.SetTwoSided(vec(piece.point), vec(piece.to));
      add_fixture(body, edge);
    } else if (piece.kind == PieceKind::disc) {
      b2CircleShape disc;
      disc.m_p = vec(piece.point);
      disc.m_radius = static_cast<float>(piece.radius);
      add_fixture(body, disc);
    } else {
      const int n = ring_edges(piece.radius, box2d_ring_depth);
      std::vector<b2Vec2> corners;
      for (int k = 0; k < n; ++k) {  // clockwise: its edges act to their right, which is inside
        const double angle = -2 * std::numbers::pi * k / n;
        corners.push_back(vec(along(piece.point, piece.radius + skin, {std::cos(angle), std::sin(angle), 0.0})));
      }
      b2ChainShape chain;
      chain.CreateLoop(corners.data(), n);
      add_fixture(body, chain);
    }
  }

  static Party& party(b2Fixture* fixture) { return *reinterpret_cast<Party*>(fixture->GetUserData().pointer); }

  [[nodiscard]] ContactKey key(b2Contact* contact) const {
    b2Fixture *a = contact->GetFixtureA(), *b = contact->GetFixtureB();
    if (party(a).piece != nullptr) std::swap(a, b);
    return contact_key(party(a), party(b), point(a->GetBody()->GetPosition()), point(b->GetBody()->GetPosition()));
  }

  void PreSolve(b2Contact* contact, const b2Manifold*) override {
    contact->SetRestitution(
        static_cast<float>(layout_.restitution_of(party(contact->GetFixtureA()), party(contact->GetFixtureB()))));
    b2WorldManifold found;
    contact->GetWorldManifold(&found);
    runs_.touch(key(contact), -static_cast<double>(found.separations[0]), 0.0);
  }
  void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
    double sum = 0.0;
    for (int k = 0; k < impulse->count; ++k) sum += static_cast<double>(impulse->normalImpulses[k]);
    runs_.touch(key(contact), 0.0, sum);
  }
  void EndContact(b2Contact* contact) override {
    ContactKey over = key(contact);
    runs_.end(over);
    const Party &a = party(contact->GetFixtureA()), &b = party(contact->GetFixtureB());
    const Piece* piece = a.piece != nullptr ? a.piece : b.piece;
    if (piece == nullptr) return;
    for (const std::int32_t feature : {piece->feature, piece->point_feature, piece->to_feature}) {
      over.feature = feature;  // the ball may have slid from the edge to its end
      runs_.end(over);
    }
  }

  std::optional<double> threshold_{};
  std::vector<Party> parties_{};
  b2World world_;
  std::vector<b2Body*> balls_{};
};

}  // namespace

std::unique_ptr<Stepper> make_box2d(Layout layout, const GameEngineOptions& options) {
  return std::make_unique<Box2D>(std::move(layout), options);
}

std::string box2d_version() { return fmt::format("{}.{}.{}", b2_version.major, b2_version.minor, b2_version.revision); }

}  // namespace carom::game_engine
