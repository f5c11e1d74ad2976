// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/command_line.h"

int main(int argc, char** argv) { return horopter::scenarios::RunCommandLine(argc, argv); }
