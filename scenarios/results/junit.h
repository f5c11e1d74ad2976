// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// JUnit XML as Jenkins' xUnit plugin reads it (its schema junit-10.xsd): a testsuite per run, in
/// it a testcase per expectation. An expectation that failed is a <failure>, one that did not apply
/// or was never judged is <skipped>. A run that did not come to its end has one more testcase,
/// "run": with an <error> when it stopped with one or is incomplete, with a <failure> when a step
/// gave up or its time ran out. The seed, and value, limit and unit of every expectation, are
/// properties of the suite, named "<expectation>.value" and so on, since the schema has no place
/// for them in a testcase.
std::string JunitXml(const std::vector<RunSummary>& runs);

}  // namespace horopter::scenarios
