/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * write_log <log.csv> <out>: the CSV's columns time, theta and tau_m as a MAT file, or, where that is
 * what it is compiled for (-DHDF5), as an HDF5 file. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 100000 };
static double column[3][MOST];
static size_t rows;

static void read_csv(const char *path)
{
    char line[4096];
    FILE *file = fopen(path, "r");
    if (!file || !fgets(line, sizeof line, file)) exit(2);
    while (rows < MOST && fscanf(file, "%lf,%lf,%lf%*[^\n]", &column[0][rows], &column[1][rows],
                                 &column[2][rows]) == 3)
        ++rows;
    fclose(file);
}

#ifdef HDF5
#include <hdf5.h>

static void write_dataset(hid_t group, const char *name, const double *values, const char *unit)
{
    const hsize_t shape[1] = {rows};
    const hid_t space = H5Screate_simple(1, shape, NULL);
    const hid_t set = H5Dcreate2(group, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT,
                                 H5P_DEFAULT);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    const hid_t text = H5Tcopy(H5T_C_S1);
    H5Tset_size(text, strlen(unit) + 1);
    const hid_t one = H5Screate(H5S_SCALAR);
    const hid_t attribute = H5Acreate2(set, "units", text, one, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, text, unit);
    H5Aclose(attribute);
    H5Sclose(one);
    H5Tclose(text);
    H5Dclose(set);
    H5Sclose(space);
}

int main(int argc, char **argv)
{
    if (argc != 3) return 2;
    read_csv(argv[1]);
    const hid_t file = H5Fcreate(argv[2], H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    write_dataset(file, "time", column[0], "s");
    write_dataset(file, "theta", column[1], "rad");
    write_dataset(file, "tau_m", column[2], "N*m");
    return H5Fclose(file) < 0;
}
#else
#include <matio.h>

static void write_variable(mat_t *mat, const char *name, double *values)
{
    size_t shape[2] = {rows, 1};
    matvar_t *v = Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, shape, values, 0);
    Mat_VarWrite(mat, v, MAT_COMPRESSION_NONE);
    Mat_VarFree(v);
}

static void write_text(mat_t *mat, const char *name, char *text)
{
    size_t shape[2] = {1, strlen(text)};
    matvar_t *v = Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, shape, text, 0);
    Mat_VarWrite(mat, v, MAT_COMPRESSION_NONE);
    Mat_VarFree(v);
}

int main(int argc, char **argv)
{
    char radian[] = "rad", torque[] = "N*m", note[] = "no channel";
    if (argc != 3) return 2;
    read_csv(argv[1]);
    mat_t *mat = Mat_CreateVer(argv[2], NULL, MAT_FT_MAT5);
    if (!mat) return 1;
    write_variable(mat, "t_s", column[0]);
    write_variable(mat, "theta", column[1]);
    write_text(mat, "theta_unit", radian);
    write_variable(mat, "tau_m", column[2]);
    write_text(mat, "tau_m_unit", torque);
    write_text(mat, "note", note);
    Mat_Close(mat);
    return 0;
}
#endif
