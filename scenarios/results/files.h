// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace horopter::scenarios {

/// Creates a folder and what is above it. @throws ResultsError
void CreateFolder(const std::filesystem::path& folder);

/// What a replaced file outlives: the death of the process, or also a loss of power, which takes a
/// flush of the disk's caches (some 0.1 s under load).
enum class Durability { kProcess, kPower };

/// Replaces the file whole: a reader, or a crash, sees the old content or the new, never a part.
/// Writes a temporary in the same folder and renames it.
/// @throws ResultsError; the old content then stands and the temporary is gone
void WriteFileAtomically(const std::filesystem::path& file, std::string_view content,
                         Durability durability = Durability::kPower);

/// @throws ResultsError
std::string ReadFile(const std::filesystem::path& file);

/// Writes all bytes to a descriptor, over interruptions.
/// @param file for the message @throws ResultsError
void WriteFully(int descriptor, std::string_view content, const std::filesystem::path& file);

/// "cannot write results to PLACE: REASON; REMEDY" for an errno value.
std::string WriteFailure(const std::filesystem::path& place, int error);

}  // namespace horopter::scenarios
