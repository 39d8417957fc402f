// Scenes in Bullet 3: spheres that do not rotate, held on a line or in a plane where the scene has fewer dimensions.

#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>

#include "adapters.hpp"
#include "bullet_mesh.hpp"
#include "engine_stepper.hpp"

namespace carom::game_engine {

namespace {

btVector3 vec(const Point& x) {
  return {static_cast<btScalar>(x[0]), static_cast<btScalar>(x[1]), static_cast<btScalar>(x[2])};
}
Point point(const btVector3& x) {
  return {static_cast<double>(x.x()), static_cast<double>(x.y()), static_cast<double>(x.z())};
}
btTransform at(const Point& x) { return btTransform(btQuaternion::getIdentity(), vec(x)); }

const Party& party(const btCollisionObject* object) { return *static_cast<const Party*>(object->getUserPointer()); }

/// Gives every contact the restitution of its parties before the solver sees it. Contacts that continuous detection
/// predicts keep Bullet's own, which is 0.
class DynamicsWorld final : public btDiscreteDynamicsWorld {
 public:
  DynamicsWorld(const Layout& layout, btDispatcher* dispatcher, btBroadphaseInterface* broadphase,
                btConstraintSolver* solver, btCollisionConfiguration* configuration)
      : btDiscreteDynamicsWorld(dispatcher, broadphase, solver, configuration), layout_(layout) {}

  void solveConstraints(btContactSolverInfo& info) override {
    for (int i = 0; i < m_dispatcher1->getNumManifolds(); ++i) {
      btPersistentManifold* manifold = m_dispatcher1->getManifoldByIndexInternal(i);
      if (m_predictiveManifolds.findLinearSearch(manifold) < m_predictiveManifolds.size()) continue;
      const double e = layout_.restitution_of(party(manifold->getBody0()), party(manifold->getBody1()));
      for (int k = 0; k < manifold->getNumContacts(); ++k)
        manifold->getContactPoint(k).m_combinedRestitution = static_cast<btScalar>(e);
    }
    btDiscreteDynamicsWorld::solveConstraints(info);
  }

 private:
  const Layout& layout_;
};

class Bullet final : public EngineStepper {
 public:
  Bullet(Layout layout, const GameEngineOptions& options)
      : EngineStepper(std::move(layout), options.dt, RunEnd::silence), awake_(options.awake) {
    world_.setGravity(vec(layout_.acceleration));
    if (options.threshold)
      world_.getSolverInfo().m_restitutionVelocityThreshold =
          static_cast<btScalar>(std::ldexp(*options.threshold, layout_.length));
    parties_.reserve(layout_.bodies.size() + layout_.pieces.size());  // bodies hold their addresses
    for (std::size_t i = 0; i < layout_.bodies.size(); ++i) add_ball(i, options.continuous);
    for (const Piece& piece : layout_.pieces) add_piece(piece);
  }
  ~Bullet() override {
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  Bullet(const Bullet&) = delete;
  Bullet& operator=(const Bullet&) = delete;

 private:
  /// Bodies without dynamics are put where they are at the end of the step; Bullet takes their velocity from that.
  void advance() override {
    for (std::size_t i = 0; i < layout_.bodies.size(); ++i)
      if (layout_.bodies[i].kind == BodyKind::driven)
        bodies_[i]->getMotionState()->setWorldTransform(at(driven_position(i, step_ + 1)));
    for (std::size_t k = layout_.bodies.size(); k < bodies_.size(); ++k)
      if (bodies_[k]->isKinematicObject()) bodies_[k]->getMotionState()->setWorldTransform(at(next_origin(*bodies_[k])));
    world_.stepSimulation(static_cast<btScalar>(dt_), 0);
    tell_contacts();
  }
  static Point origin(const Piece& piece) { return piece.kind == PieceKind::disc ? piece.point : Point{}; }
  [[nodiscard]] Point next_origin(const btRigidBody& wall) const {
    const Piece& piece = *party(&wall).piece;
    return along(origin(piece), static_cast<double>(step_ + 1) * dt_, piece.velocity);
  }
  [[nodiscard]] Point position(std::size_t i) const override { return point(bodies_[i]->getWorldTransform().getOrigin()); }
  [[nodiscard]] Point velocity(std::size_t i) const override { return point(bodies_[i]->getLinearVelocity()); }

  /// mass 0: fixed or driven.
  btRigidBody& add_body(std::unique_ptr<btCollisionShape> shape, double mass, const Point& position, bool driven) {
    shapes_.push_back(std::move(shape));
    states_.push_back(std::make_unique<btDefaultMotionState>(at(position)));
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass), states_.back().get(), shapes_.back().get());
    info.m_friction = 0;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *bodies_.back();
    body.setUserPointer(&parties_.back());
    if (driven) {
      body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
      body.setActivationState(DISABLE_DEACTIVATION);
    }
    world_.addRigidBody(&body);
    return body;
  }

  void add_ball(std::size_t i, bool continuous) {
    const Body& ball = layout_.bodies[i];
    const bool dynamic = ball.kind == BodyKind::dynamic;
    const auto radius = static_cast<btScalar>(ball.radius);
    parties_.push_back({nullptr, static_cast<std::uint32_t>(i)});
    btRigidBody& body = add_body(std::make_unique<btSphereShape>(radius), dynamic ? ball.mass : 0.0, ball.position,
                                 ball.kind == BodyKind::driven);
    if (!dynamic) return;
    body.setLinearVelocity(vec(ball.velocity));
    body.setLinearFactor(
        {1, layout_.dimension > 1 ? btScalar(1) : btScalar(0), layout_.dimension > 2 ? btScalar(1) : btScalar(0)});
    body.setAngularFactor(0);
    if (awake_) body.setActivationState(DISABLE_DEACTIVATION);
    if (!continuous) return;
    body.setCcdMotionThreshold(radius);
    body.setCcdSweptSphereRadius(btScalar(0.4) * radius);
  }

  void add_piece(const Piece& piece) {
    parties_.push_back({&piece, 0});
    std::unique_ptr<btCollisionShape> shape;
    if (piece.kind == PieceKind::half_space) {
      shape =
          std::make_unique<btStaticPlaneShape>(vec(piece.normal), static_cast<btScalar>(dot(piece.normal, piece.point)));
    } else if (piece.kind == PieceKind::disc) {
      shape = std::make_unique<btSphereShape>(static_cast<btScalar>(piece.radius));
    } else {
      meshes_.push_back(mesh_of(piece, layout_.dimension, 4 * layout_.largest_radius));
      shape = std::make_unique<btBvhTriangleMeshShape>(meshes_.back().get(), true);
    }
    add_body(std::move(shape), 0.0, origin(piece), norm(piece.velocity) > 0);
  }

  /// The manifolds hold what the step has found and done until the next one.
  void tell_contacts() {
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(i);
      const btCollisionObject *a = manifold->getBody0(), *b = manifold->getBody1();
      if (party(a).piece != nullptr) std::swap(a, b);
      double overlap = 0.0, impulse = 0.0;
      bool touching = false;
      for (int k = 0; k < manifold->getNumContacts(); ++k) {
        const btManifoldPoint& found = manifold->getContactPoint(k);
        if (found.getDistance() > 0 && found.getAppliedImpulse() <= 0) continue;
        touching = true;
        overlap = std::max(overlap, -static_cast<double>(found.getDistance()));
        impulse += static_cast<double>(found.getAppliedImpulse());
      }
      if (!touching) continue;
      const ContactKey key = contact_key(party(a), party(b), point(a->getWorldTransform().getOrigin()),
                                         point(b->getWorldTransform().getOrigin()));
      runs_.touch(key, overlap, impulse);
    }
  }

  bool awake_;
  std::vector<Party> parties_{};
  btDefaultCollisionConfiguration configuration_{};
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_{};
  btSequentialImpulseConstraintSolver solver_{};
  DynamicsWorld world_{layout_, &dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btTriangleMesh>> meshes_{};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_{};
  std::vector<std::unique_ptr<btMotionState>> states_{};
  std::vector<std::unique_ptr<btRigidBody>> bodies_{};  // the balls, then the walls
};

}  // namespace

std::unique_ptr<Stepper> make_bullet(Layout layout, const GameEngineOptions& options) {
  return std::make_unique<Bullet>(std::move(layout), options);
}

std::string bullet_version() { return fmt::format("{}.{:02}", BT_BULLET_VERSION / 100, BT_BULLET_VERSION % 100); }

}  // namespace carom::game_engine
