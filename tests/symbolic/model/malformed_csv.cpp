// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/symbolic/model/malformed_case.h"

namespace malformed {

const std::string_view sound_csv =
    R"(# mass properties of the arm
link,mass [kg],com_x [m],com_y [m],com_z [m],ixx [kg*m^2],iyy [kg*m^2],izz [kg*m^2],ixy [kg*m^2],ixz [kg*m^2],iyz [kg*m^2],iyx [kg*m^2],from,ref,note
upper,0.5,0.05,0,0.001,1.5e-4,4e-4,5e-4,1e-5,2e-5,3e-5,1e-5,cad,,
lower,0.25,0.04,0,0,6e-5,2.1e-4,2.2e-4,0,0,0,0,assumed,rod,
slide,0.1,0.01,0,0,1.1e-5,1.2e-5,1.3e-5,0,0,0,0,text,Table 2,"a, b"
)";

const std::vector<Case>& csv_cases() {
  static const std::vector<Case> cases{
      // header
      {"mass [kg]", "mass", "mass,com_x", "column 'mass' has no unit"},
      {"mass [kg]", "mass []", "mass []", "column 'mass' has no unit"},
      {"mass [kg]", "mass [m]", "mass [m]", "has the unit 'm' of length"},
      {"mass [kg]", "mass [lb]", "mass [lb]", "unknown unit 'lb'"},
      {"mass [kg]", "mass [kg", "mass [kg,", "does not end with ]"},
      {"mass [kg]", "mess [kg]", "mess [kg]", "unknown column 'mess' (did you mean 'mass'?)"},
      {"mass [kg]", "mess [kg]", "link,", "column 'mass' is missing"},
      {",mass [kg]", "", "link,", "column 'mass' is missing; expected a column 'mass [kg]'"},
      {"link,mass", "name,mass", "name", "unknown column 'name'"},
      {"link,mass", "lnik,mass", "lnik", "unknown column 'lnik' (did you mean 'link'?)"},
      {"link,mass", "link [m],mass", "link [m]", "column 'link' has a unit"},
      {"com_y [m]", "com_x [m]", "com_x [m],com_z", "column 'com_x' appears twice"},
      {"com_y [m]", "com_x [m]", "link,", "column 'com_y' is missing"},
      {"com_y [m]", "com_y [rad]", "com_y [rad]", "has the unit 'rad' of angle"},
      {"com_y [m]", "com_y [kg*m^2]", "com_y [kg*m^2]", "of inertia"},
      {"com_y [m]", "volume [m]", "volume [m]", "unknown column 'volume'"},
      {"com_y [m]", "", ",com_z", "unknown column ''"},
      {"izz [kg*m^2]", "izz [kg*m]", "izz [kg*m]", "unknown unit 'kg*m'"},
      {"izz [kg*m^2]", "izz [m]", "izz [m]", "has the unit 'm' of length"},
      {"izz [kg*m^2]", "Izz [kg*m^2]", "Izz", "unknown column 'Izz' (did you mean"},
      {"iyz [kg*m^2]", "izy [kg*m^2]", "link,", "column 'iyz' is missing"},
      {"from,ref", "from,from", "from,note", "column 'from' appears twice"},
      {"from,ref", "form,ref", "form,ref", "unknown column 'form' (did you mean 'from'?)"},
      {"link,mass [kg],com_x [m]", "link;mass [kg];com_x [m]", "link;mass", "unknown column"},
      // rows
      {"upper,0.5,", "upper,", "upper,0.05", "the row has 14 cells; expected 15"},
      {"upper,0.5,", "upper,0.5,0,", "upper,", "the row has 16 cells; expected 15"},
      {"slide,0.1", "\nslide 0.1", "slide 0.1", "the row has 14 cells"},
      {"upper,0.5,", "upper,0.5x,", "0.5x", "mass '0.5x' is not a number"},
      {"upper,0.5,", "upper,half,", "half", "mass 'half' is not a number"},
      {"upper,0.5,", "upper,,", ",0.05,0,0.001", "mass is empty; expected a number"},
      {"upper,0.5,", "upper, ,", ",0.05,0,0.001", "mass is empty"},
      {"upper,0.5,", "upper,\"0,5\",", "\"0,5\"",
       "mass '0,5' is not a number; expected a number with a decimal point"},
      {"upper,0.5,", "upper,0x1p-1,", "0x1p-1", "is not a number"},
      {"upper,0.5,", "upper,++0.5,", "++0.5", "is not a number"},
      {"upper,0.5,", "upper,0.5 kg,", "0.5 kg", "is not a number"},
      {"upper,0.5,", "upper,nan,", "nan", "mass 'nan' is not finite"},
      {"upper,0.5,", "upper,-inf,", "-inf", "mass '-inf' is not finite"},
      {"upper,0.5,", "upper,1e999,", "1e999", "is out of range"},
      {"upper,0.5,", "upper,0,", "0,0.05", "the mass of 'upper' is 0 kg; expected a mass > 0"},
      {"upper,0.5,", "upper,-0.5,", "-0.5", "the mass of 'upper' is -0.5 kg"},
      {"upper,0.5,", "uper,0.5,", "uper",
       "the mechanism has no body 'uper' (did you mean 'upper'?)"},
      {"upper,0.5,", "arm,0.5,", "arm,", "the mechanism has no body 'arm'"},
      {"upper,0.5,", ",0.5,", ",0.5,", "the mechanism has no body ''"},
      {"upper,0.5,", "lower,0.5,", "lower,0.25", "is defined a second time, first in line 3"},
      {"upper,0.5,", "plate,0.5,", "plate", "body 'plate' is massless but has a row"},
      {"upper,0.5,", "\"upper,0.5,", "a, b\"", "text follows a quoted cell"},
      {"upper,0.5,", "\"upper\"x,0.5,", "x,0.5", "text follows a quoted cell"},
      {"0.05,0,0.001", "0.05,0,1mm", "1mm", "com_z '1mm' is not a number"},
      {"0.05,0,0.001", "0.05,inf,0.001", "inf", "com_y 'inf' is not finite"},
      // inertias
      {"1.5e-4,4e-4,5e-4", "1.5e-4,4e-4,0", "1.5e-4", "not positive definite"},
      {"1.5e-4,4e-4,5e-4", "1.5e-4,-4e-4,5e-4", "1.5e-4", "not positive definite"},
      {"1.5e-4,4e-4,5e-4", "0,0,0", "0,0,0,1e-5", "not positive definite"},
      {"1.5e-4,4e-4,5e-4", "1.5e-4,4e-4,6e-4", "1.5e-4", "violates the triangle inequality"},
      {"1.5e-4,4e-4,5e-4", "1.5e-4,8e-4,5e-4", "1.5e-4", "violates the triangle inequality"},
      {"1.5e-4,4e-4,5e-4", "15e-4,4e-4,5e-4", "15e-4", "violates the triangle inequality"},
      {"1.5e-4,4e-4,5e-4", "1.5e-4,4e-4,5.e-", "5.e-", "is not a number"},
      {"6e-5,2.1e-4,2.2e-4", "-1e-6,2e-4,2e-4", "-1e-6", "not positive definite"},
      {"6e-5,2.1e-4,2.2e-4,0,0,0,0", "6e-5,2.1e-4,2.2e-4,5e-4,0,0,5e-4", "6e-5",
       "not positive definite"},
      {"2e-5,3e-5,1e-5", "2e-5,3e-5,-1e-5", "-1e-5",
       "the inertia is not symmetric: ixy = 1e-05 and iyx = -1e-05"},
      {"2e-5,3e-5,1e-5", "2e-5,3e-5,2e-5", "2e-5,cad", "the inertia is not symmetric"},
      {"2e-5,3e-5,1e-5", "2e-4,3e-4,1e-5", "1.5e-4", "violates the triangle inequality"},
      // origins
      {"cad,,", "CAD,,", "CAD", "from is 'CAD'; expected one of: text, assumed"},
      {"assumed,rod", "guess,rod", "guess", "from is 'guess'"},
      {"text,Table 2", "text,", "text,", "from the text but does not say where"},
      // whole files
      {sound_csv, "", "^", "the table is empty; expected a header row"},
      {sound_csv, "# nothing\n\n \n", "^", "the table is empty"},
      {sound_csv, "link;mass [kg]\nupper;1\n", "^", "separated by semicolons; expected commas"},
      {sound_csv, "\xEF\xBB\xBFmass [kg]\n", "^", "column 'link' is missing"},
      {sound_csv, "\"", "^", "the quoted cell does not end"},
  };
  return cases;
}

}  // namespace malformed
