#include "cli/help.hpp"

namespace tripus::cli {

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
  if (app->get_parent() == nullptr) return "\nUsage: tripus VERB [INPUT] [OPTIONS]\n";
  std::string usage = "\nUsage: " + name;
  for (const CLI::Option* positional :
       app->get_options([](const CLI::Option* option) { return option->get_positional(); }))
    usage += " " + positional->get_name(true, false);
  usage += " [OPTIONS]\n";
  if (app->get_option_no_throw("--batch") != nullptr)
    usage += "       " + name + " --batch FILE [OPTIONS]\n";
  return usage;
}

const char* const kInputHelp =
    "INPUT, an ideal triangulation, is one of\n"
    "  a signature   isomorphism signature as Regina writes it, cPcbbbihq; with a sign, "
    "cPcbbbihq+,\n"
    "                it keeps the orientation\n"
    "  a file        JSON gluing table, Regina (XML data file or printed gluing table), SnapPea "
    "or\n"
    "                Orb triangulation, or one signature; FILE#LABEL is one of several;\n"
    "                or a solid by its boundary (OFF, OBJ, STL, PLY) or in tetrahedra (TetGen), "
    "or\n"
    "                either (VTK, VTK XML, Gmsh, Medit): `tripus mesh --help` says how it becomes\n"
    "                a triangulation; all recognised by content, gzip-compressed or not\n"
    "  a diagram     PD: X[4,2,5,1] V[1,2,3] ... (arcs counterclockwise; \"PD clockwise:\" for\n"
    "                SageMath's), lists of lists, DT: or Braid:, JSON; as it is or in a file\n"
    "  a name        of the tables: t3g2.13, 8_19, L5a1, '5_1 theta', hk5_3\n"
    "  -             the same from standard input\n";

const char* const kOutcomeHelp =
    "The outcome is one of\n"
    "  geometric     the metric was found: every tetrahedron is a true truncated one and the\n"
    "                edge curvatures K vanish to the tolerance\n"
    "  degenerate    the minimiser has flat tetrahedra: no metric on this triangulation\n"
    "  infeasible    no strict angle structure, with a certificate: no metric on this "
    "triangulation\n"
    "  unresolved    a limit was reached; the message says which and what is known\n"
    "Only geometric says something about the manifold: another triangulation of it may carry a\n"
    "metric where this one does not.\n";

const char* const kExitStatusHelp =
    "Exit status: 0 a geometric answer (for --batch: the run finished), 1 a mathematical \"no\",\n"
    "unresolved or interrupted, 2 bad usage or bad input, 3 a failure of the program itself.";

}  // namespace tripus::cli
