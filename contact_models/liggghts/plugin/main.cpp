// SPDX-License-Identifier: GPL-2.0-or-later
//
// liggghts-plastigran: stock LIGGGHTS with the contact laws of libplastigran loaded. Same command
// line as `liggghts`; two checks more: a `-var` the deck never mentions is a misspelling, not a
// no-op, and a contact model that is unknown is named.
#include <mpi.h>
#include <signal.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <map>
#include <string>

#include "deck_words.h"
#include "input.h"
#include "lammps.h"
#include "signal_handling.h"

namespace {

// What the command line says of the deck.
struct CommandLine {
  std::string path;
  std::map<std::string, std::string> values;  // of -var, each by its first word

  CommandLine(int argc, char** argv) {
    for (int i = 1; i + 1 < argc; ++i) {
      if (!std::strcmp(argv[i], "-in") || !std::strcmp(argv[i], "-i"))
        path = argv[++i];
      else if ((!std::strcmp(argv[i], "-var") || !std::strcmp(argv[i], "-v")) && i + 2 < argc) {
        values[argv[i + 1]] = argv[i + 2];
        i += 2;
      }
    }
  }
};

// The complaint about a -var the deck does not know, or an empty string.
std::string misspelt_variable(const CommandLine& given, const plastigran::DeckWords& deck) {
  for (const auto& [name, value] : given.values) {
    if (deck.may_use(name)) continue;
    std::string message = "-var " + name + ": " + given.path + " has no such variable";
    if (!deck.settings().empty()) message += "; it takes";
    for (const std::string& setting : deck.settings()) message += " " + setting;
    return message;
  }
  return {};
}

// Names of contact models that there are not; the engine's own word on them names neither them nor
// those there are.
std::string unknown_models(const plastigran::DeckWords& deck) {
  const std::string known = PLASTIGRAN_MODELS;
  std::string text;
  for (const std::string& model : deck.models())
    if (model.find('$') == std::string::npos &&
        (' ' + known + ' ').find(' ' + model + ' ') == std::string::npos)
      text += "WARNING: model " + model + " is unknown; there are " + known + '\n';
  return text;
}

// Open MPI starts a daemon for a process that no launcher started, and looks for ways to reach
// others. A rank alone needs neither; together they take as long as the engine's own start. Without
// a daemon all such processes have one session directory, which one that ends takes from another
// that begins; a rank alone has nothing to keep there.
void start_alone() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(name)) return;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  setenv("OMPI_MCA_pml", "ob1", 0);
  setenv("OMPI_MCA_btl", "self", 0);
}

}  // namespace

int main(int argc, char** argv) {
  struct sigaction action;
  std::memset(&action, 0, sizeof action);
  action.sa_handler = LAMMPS_NS::SignalHandler::int_handler;  // finish the step, write what is due
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = LAMMPS_NS::SignalHandler::usr1_handler;
  sigaction(SIGUSR1, &action, nullptr);

  // One rank's error ends in MPI_Abort, which would take the buffered message with it.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  start_alone();
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const CommandLine given(argc, argv);
  const plastigran::DeckWords deck(given.path, given.values);
  const std::string complaint = misspelt_variable(given, deck);
  if (!complaint.empty()) {
    if (rank == 0) std::cerr << "ERROR: " << complaint << std::endl;
    MPI_Finalize();
    return 1;
  }
  if (rank == 0) std::cerr << unknown_models(deck);
  LAMMPS_NS::LAMMPS* engine = new LAMMPS_NS::LAMMPS(argc, argv, MPI_COMM_WORLD);
  engine->input->file();
  delete engine;
  MPI_Finalize();
  return 0;
}
