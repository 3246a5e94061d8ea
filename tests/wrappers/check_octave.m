% SPDX-License-Identifier: GPL-3.0-or-later
function check_octave(file)
  rows = strsplit(fileread(file), "\n");
  q = values(rows, 'index_tip_jacobian,reference,q,');
  J = reshape(values(rows, 'index_tip_jacobian,reference,J,'), 4, 6)';
  assert(isequal(sinew_index.tip_jacobian(q), J));
  assert(isequal(sinew_index.tip_jacobian(q'), J));
  beside = values(rows, 'index_tip_jacobian,beside,q,');
  both = sinew_index.tip_jacobian([q beside]);
  assert(isequal(size(both), [6 4 2]));
  assert(isequal(both(:, :, 1), J));
  [M, h] = sinew_index.mass_matrix_and_bias([q beside], values(rows, 'index_mass_matrix_and_bias,reference,qd,'));
  assert(isequal(size(M), [4 4 2]) && isequal(size(h), [4 2]));
  assert(isequal(h(:, 1), values(rows, 'index_mass_matrix_and_bias,reference,h,')));
  names = sinew_index.names();
  assert(isequal(names.joints, {'q20', 'q21', 'q22', 'q23'}));
  try
    sinew_index.tip_jacobian([1 2 3]);
    error('a wrong shape is taken');
  catch problem
    assert(strcmp(problem.identifier, 'sinew:shape'));
  end
end

function v = values(rows, start)
  row = rows{find(strncmp(rows, start, numel(start)), 1)};
  v = str2double(strsplit(row(numel(start) + 1:end), ','))';
end
