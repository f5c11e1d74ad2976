// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace horopter::scenarios {

/// The rows of a CSV table below its header, checked as it is read.
class CsvTable {
 public:
  /// @param header the first line that the table must have, without its line end
  /// @param name of the file, for messages
  /// @throws FormatError naming the line: another header, a row of another number of fields, a
  /// quote
  ///         that does not end, or a last line without its end (a truncated file)
  CsvTable(std::string_view text, std::string_view header, std::string name);

  std::size_t rows() const { return rows_.size(); }
  const std::string& Text(std::size_t row, std::size_t column) const {
    return rows_.at(row).fields.at(column);
  }
  /// @throws FormatError when the field is no number
  double Number(std::size_t row, std::size_t column) const;

  /// A message about a field: "FILE:LINE: 'field': what".
  std::string At(std::size_t row, std::size_t column, std::string_view what) const;

 private:
  struct Row {
    std::vector<std::string> fields;
    int line = 0;  ///< in the file, from 1
  };

  std::string name_;
  std::vector<Row> rows_;
};

}  // namespace horopter::scenarios
