#pragma once

#include "app/esmc/context.h"

namespace esm {

// Each adds one command, or one family of them, to the command line. `docs/command-line.md` says what they
// do.
void addImportCommand(CLI::App& app, Context& context);
void addSampleCommand(CLI::App& app, Context& context);
void addInfoCommand(CLI::App& app, Context& context);
void addFuzzyCommands(CLI::App& app, Context& context);
void addTissueCommand(CLI::App& app, Context& context);
void addScaleCommand(CLI::App& app, Context& context);
void addInsideCommand(CLI::App& app, Context& context);
void addSheetCommand(CLI::App& app, Context& context);
void addSceneCommand(CLI::App& app, Context& context);
void addSimulateCommand(CLI::App& app, Context& context);
void addStabilityCommand(CLI::App& app, Context& context);
void addTradeoffCommand(CLI::App& app, Context& context);
void addProbeCommand(CLI::App& app, Context& context);
void addExtremesCommand(CLI::App& app, Context& context);
void addTextureCommands(CLI::App& app, Context& context);
void addFinishCommand(CLI::App& texture, Context& context);
void addFitCommand(CLI::App& texture, Context& context);
void addBakeCommand(CLI::App& texture, Context& context);
void addExportCommand(CLI::App& app, Context& context);
void addValidateCommand(CLI::App& app, Context& context);
void addRenderCommand(CLI::App& app, Context& context);

} // namespace esm
