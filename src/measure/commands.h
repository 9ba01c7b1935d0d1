// The commands of this room, for the command line to offer.
#pragma once
#include <vector>

#include "workbench/commands.h"

namespace cg {

// trade: a knob's ladder measured. Files go to -o DIR; the summary to stdout.
int run_trade_command(const Arguments& arguments, std::span<const Technique> techniques, Language language);

std::vector<CommandOffer> measure_commands();

}  // namespace cg
