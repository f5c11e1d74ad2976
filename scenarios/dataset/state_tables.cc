// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/state_tables.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "scenarios/dataset/csv.h"
#include "scenarios/dataset/format_error.h"
#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace {

constexpr std::string_view kPoses = "body,x_m,y_m,z_m,qw,qx,qy,qz";
constexpr std::string_view kJoints = "joint,kind,position,velocity";
constexpr std::string_view kContacts =
    "geom1,geom2,body1,body2,distance_m,x_m,y_m,z_m,normal_x,normal_y,normal_z";

Eigen::Vector3d VectorAt(const CsvTable& table, std::size_t row, std::size_t column) {
  return {table.Number(row, column), table.Number(row, column + 1), table.Number(row, column + 2)};
}

sim::JointKind KindAt(const CsvTable& table, std::size_t row, std::size_t column) {
  if (table.Text(row, column) == "hinge") return sim::JointKind::kHinge;
  if (table.Text(row, column) == "slide") return sim::JointKind::kSlide;
  throw FormatError(table.At(row, column, "is neither hinge nor slide"));
}

Eigen::Matrix3d RotationAt(const CsvTable& table, std::size_t row, std::size_t column) {
  const Eigen::Quaterniond q(table.Number(row, column), table.Number(row, column + 1),
                             table.Number(row, column + 2), table.Number(row, column + 3));
  constexpr double kRounding = 1e-6;
  if (!(std::abs(q.norm() - 1) < kRounding)) {
    throw FormatError(table.At(row, column, "begins a quaternion that is not of unit length"));
  }
  return q.normalized().toRotationMatrix();
}

}  // namespace

std::string EncodePoses(const std::vector<sim::BodyPose>& bodies) {
  std::string text = fmt::format("{}\n", kPoses);
  for (const auto& [body, X_WB] : bodies) {
    const Eigen::Vector3d p = X_WB.translation();
    Eigen::Quaterniond q(X_WB.linear());
    if (q.w() < 0) q.coeffs() *= -1;
    text += fmt::format("{},{},{},{},{},{},{},{}\n", CsvField(body), p.x(), p.y(), p.z(), q.w(),
                        q.x(), q.y(), q.z());
  }
  return text;
}

std::string EncodeJoints(const std::vector<sim::JointReading>& joints) {
  std::string text = fmt::format("{}\n", kJoints);
  for (const sim::JointReading& j : joints) {
    text +=
        fmt::format("{},{},{},{}\n", CsvField(j.joint),
                    j.kind == sim::JointKind::kHinge ? "hinge" : "slide", j.position, j.velocity);
  }
  return text;
}

std::string EncodeContacts(const std::vector<sim::Contact>& contacts) {
  std::string text = fmt::format("{}\n", kContacts);
  for (const sim::Contact& c : contacts) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", CsvField(c.geom1), CsvField(c.geom2),
                        CsvField(c.body1), CsvField(c.body2), c.distance_m, c.p_W.x(), c.p_W.y(),
                        c.p_W.z(), c.normal_W.x(), c.normal_W.y(), c.normal_W.z());
  }
  return text;
}

std::vector<sim::BodyPose> DecodePoses(std::string_view text, const std::string& name) {
  const CsvTable table(text, kPoses, name);
  std::vector<sim::BodyPose> bodies;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    sim::BodyPose pose{table.Text(row, 0)};
    pose.X_WB.translation() = VectorAt(table, row, 1);
    pose.X_WB.linear() = RotationAt(table, row, 4);
    bodies.push_back(pose);
  }
  return bodies;
}

std::vector<sim::JointReading> DecodeJoints(std::string_view text, const std::string& name) {
  const CsvTable table(text, kJoints, name);
  std::vector<sim::JointReading> joints;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    joints.push_back(
        {table.Text(row, 0), KindAt(table, row, 1), table.Number(row, 2), table.Number(row, 3)});
  }
  return joints;
}

std::vector<sim::Contact> DecodeContacts(std::string_view text, const std::string& name) {
  const CsvTable table(text, kContacts, name);
  std::vector<sim::Contact> contacts;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    contacts.push_back({table.Text(row, 0), table.Text(row, 1), table.Text(row, 2),
                        table.Text(row, 3), table.Number(row, 4), VectorAt(table, row, 5),
                        VectorAt(table, row, 8)});
  }
  return contacts;
}

}  // namespace horopter::scenarios
