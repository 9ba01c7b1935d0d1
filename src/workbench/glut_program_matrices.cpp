#include "workbench/glut_program.h"

namespace cg {

const std::string_view glut_matrices = R"c(
/* ---- {{Matrices in double|倍精度の行列}} ----
 * {{These do what gluPerspective, glOrtho, gluLookAt, glTranslate, glRotate and glScale do,|gluPerspective、glOrtho、gluLookAt、glTranslate、glRotate、glScale と同じことを}}
 * {{with the same numbers. OpenGL multiplies in float; here all is rounded once, at the end,|同じ引数で行う。OpenGL は float で掛けるが、ここでは最後に一度だけ丸めるので、}}
 * {{so that every corner falls on the same pixel as in Shadebench.|頂点が Shadebench と同じ画素に落ちる。}} */

#define PI 3.14159265358979323846

double matrix[16]; /* matrix[4 * {{column + row|列 + 行}}] */

void load_identity( void )
{
    int i;

    for ( i = 0; i < 16; i++ )
        matrix[i] = i % 5 == 0 ? 1.0 : 0.0;
}

void copy( double to[16], const double from[16] )
{
    int i;

    for ( i = 0; i < 16; i++ )
        to[i] = from[i];
}

/* matrix = a b */
void multiply( const double a[16], const double b[16] )
{
    double product[16];
    int row, column;

    for ( column = 0; column < 4; column++ )
        for ( row = 0; row < 4; row++ )
            product[4 * column + row] = a[row] * b[4 * column] + a[4 + row] * b[4 * column + 1] +
                                        a[8 + row] * b[4 * column + 2] + a[12 + row] * b[4 * column + 3];
    copy( matrix, product );
}

/* {{matrix = matrix b, whose columns are these|matrix = matrix b。引数は b の列}} */
void multiply_by( double ax, double ay, double az, double bx, double by, double bz, double cx, double cy, double cz,
                  double dx, double dy, double dz )
{
    double b[16];

    b[0] = ax, b[1] = ay, b[2] = az, b[3] = 0.0;
    b[4] = bx, b[5] = by, b[6] = bz, b[7] = 0.0;
    b[8] = cx, b[9] = cy, b[10] = cz, b[11] = 0.0;
    b[12] = dx, b[13] = dy, b[14] = dz, b[15] = 1.0;
    multiply( matrix, b );
}

void translate( double x, double y, double z )
{
    multiply_by( 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, x, y, z );
}

/* {{about the axis (x, y, z) of length 1|長さ 1 の軸 (x, y, z) のまわり}} */
void rotate( double degrees, double x, double y, double z )
{
    double angle = degrees * ( PI / 180 ), c = cos( angle ), s = sin( angle ), t = 1 - c;

    multiply_by( t * x * x + c, t * x * y + s * z, t * x * z - s * y, t * x * y - s * z, t * y * y + c,
                 t * y * z + s * x, t * x * z + s * y, t * y * z - s * x, t * z * z + c, 0.0, 0.0, 0.0 );
}

void scale( double x, double y, double z )
{
    multiply_by( x, 0.0, 0.0, 0.0, y, 0.0, 0.0, 0.0, z, 0.0, 0.0, 0.0 );
}
)c";

const std::string_view glut_perspective = R"c(
void perspective( double fov, double aspect, double near_plane, double far_plane )
{
    double cotangent = 1 / tan( fov * ( PI / 180 ) / 2 );

    matrix[0] = cotangent / aspect;
    matrix[5] = cotangent;
    matrix[10] = -( far_plane + near_plane ) / ( far_plane - near_plane );
    matrix[11] = -1.0;
    matrix[14] = -2 * far_plane * near_plane / ( far_plane - near_plane );
    matrix[15] = 0.0;
}
)c";

const std::string_view glut_orthographic = R"c(
void orthographic( double left, double right, double bottom, double top, double near_plane, double far_plane )
{
    matrix[0] = 2 / ( right - left );
    matrix[5] = 2 / ( top - bottom );
    matrix[10] = -2 / ( far_plane - near_plane );
    matrix[12] = -( right + left ) / ( right - left );
    matrix[13] = -( top + bottom ) / ( top - bottom );
    matrix[14] = -( far_plane + near_plane ) / ( far_plane - near_plane );
}
)c";

const std::string_view glut_vectors = R"c(
double dot( const double a[3], const double b[3] )
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void normalize( double v[3] )
{
    double length = sqrt( dot( v, v ) );
    int i;

    for ( i = 0; i < 3 && length > 0; i++ )
        v[i] /= length;
}
)c";

const std::string_view glut_look_at = R"c(
void cross( double c[3], const double a[3], const double b[3] )
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

void look_at( double eye_x, double eye_y, double eye_z, double target_x, double target_y, double target_z,
              double up_x, double up_y, double up_z )
{
    double position[3], forward[3], side[3], above[3];

    position[0] = eye_x, position[1] = eye_y, position[2] = eye_z;
    forward[0] = target_x - eye_x, forward[1] = target_y - eye_y, forward[2] = target_z - eye_z;
    above[0] = up_x, above[1] = up_y, above[2] = up_z;
    normalize( forward );
    normalize( above );
    cross( side, forward, above );
    normalize( side );
    cross( above, side, forward );
    multiply_by( side[0], above[0], -forward[0], side[1], above[1], -forward[1], side[2], above[2], -forward[2],
                 -dot( side, position ), -dot( above, position ), dot( forward, position ) );
}
)c";

const std::string_view glut_modelview = R"c(
void begin_object( void )
{
    load_identity();
    rotate( model_angle, 0.0, 1.0, 0.0 );
}

void load_modelview( void )
{
    multiply( view, matrix );
    glLoadMatrixd( matrix );
}
)c";

}  // namespace cg
