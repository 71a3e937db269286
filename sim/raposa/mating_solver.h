// Bullet's contact solver for an articulated body against a free one, with its rows side by side.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>

#include <Eigen/Core>
#include <vector>

namespace dockyard::raposa {

/// Solves what Bullet's own solver does, by the same sweeps in the same order: rows along the
/// normals, then pairs of rows across them within the cone of friction. It ends early once a sweep
/// has changed no velocity at a contact by more than `settled_m_s`.
class MatingSolver : public btMultiBodyConstraintSolver {
 public:
  explicit MatingSolver(double settled_m_s) : settled_m_s_(settled_m_s) {}
  /// Of the last step with contacts.
  int sweeps() const { return sweeps_; }

 protected:
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int numBodies,
                                btPersistentManifold** manifoldPtr, int numManifolds,
                                btTypedConstraint** constraints, int numConstraints,
                                const btContactSolverInfo& infoGlobal,
                                btIDebugDraw* debugDrawer) override;

 private:
  // Speeds of the articulated body's freedoms, then the free body's velocity and turning.
  static constexpr int kMostFreedoms = 10, kFreedoms = kMostFreedoms + 6;
  using Speeds = Eigen::Matrix<double, kFreedoms, 1>;
  struct Row {
    Speeds jacobian, answer;  // answer: the speeds that a unit impulse gives
    double rhs, softness, per_speed, impulse, friction;
    int normal;  // of a row across it
  };
  struct Bodies {
    btMultiBody* articulated = nullptr;
    int speeds = -1, free = -1;  // places in Bullet's arrays
  };

  bool IsOurs() const;
  bool TakeRow(const btMultiBodySolverConstraint& from, Bodies& bodies, Row& row);
  bool TakeRows();
  double Sweep();
  void GiveBack();
  double Wanted(const Row& row) const {
    return row.rhs - row.impulse * row.softness - row.jacobian.dot(speeds_) * row.per_speed;
  }
  double Push(Row& row, double impulse);

  double settled_m_s_ = 0.0;
  int sweeps_ = 0;
  Bodies bodies_;
  Speeds taken_, speeds_;  // changes of the speeds in this step, before and after the sweeps
  std::vector<Row> along_, across_;
};

}  // namespace dockyard::raposa
