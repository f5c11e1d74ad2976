// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/truth/world_state.h"

namespace horopter::scenarios {

/// True states as CSV tables with a header line: metres, radians, unit quaternions with a
/// non-negative w first; frame W. Numbers have the shortest digits that read back exactly, but for
/// a pose's rotation, which reads back to 1e-15.
std::string EncodePoses(const std::vector<sim::BodyPose>& bodies);
std::string EncodeJoints(const std::vector<sim::JointReading>& joints);
std::string EncodeContacts(const std::vector<sim::Contact>& contacts);

/// @param name of the file, for messages
/// @throws FormatError naming file, line and field
std::vector<sim::BodyPose> DecodePoses(std::string_view text, const std::string& name);
std::vector<sim::JointReading> DecodeJoints(std::string_view text, const std::string& name);
std::vector<sim::Contact> DecodeContacts(std::string_view text, const std::string& name);

}  // namespace horopter::scenarios
