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

const std::string_view glut_meshes = R"c(
/* ---- {{The meshes|メッシュ}} ---- */

struct list {
    float *numbers; /* {{three each|三つずつ}} */
    long count, room;
};

struct list vertices, normals; /* {{of the triangles' corners, all meshes|三角形の頂点。全メッシュ}} */
long first[meshes + 1];        /* {{mesh m has|メッシュ m は}} first[m] .. first[m + 1] - 1 */

void append( struct list *list, double x, double y, double z )
{
    float *end;

    if ( list->count == list->room ) {
        list->room = 2 * list->room + 1000;
        list->numbers = realloc( list->numbers, list->room * 3 * sizeof( float ) );
        if ( list->numbers == NULL ) {
            fprintf( stderr, "{{not enough memory|メモリー不足}}\n" );
            exit( 1 );
        }
    }
    end = list->numbers + 3 * list->count++;
    end[0] = (float) x, end[1] = (float) y, end[2] = (float) z;
}

void append_copy( struct list *list, const struct list *from, long i )
{
    const float *v = from->numbers + 3 * ( i - 1 ); /* {{OBJ counts from 1|OBJ の番号は 1 から}} */

    if ( i < 1 || i > from->count ) {
        fprintf( stderr, "{{a face names a corner that is not there|面の頂点番号が範囲外}}\n" );
        exit( 1 );
    }
    append( list, v[0], v[1], v[2] );
}

void skip_line( FILE *file )
{
    int c;

    do
        c = getc( file );
    while ( c != '\n' && c != EOF );
}

/* " 12//34", " 12/56/34": {{a position, perhaps a uv, a normal; 0 at the end of the line|位置、（あれば uv、）法線。行末なら 0}} */
int read_corner( FILE *file, long *position, long *normal )
{
    int c = getc( file );

    while ( c == ' ' || c == '\r' )
        c = getc( file );
    if ( c == '\n' || c == EOF )
        return 0;
    ungetc( c, file );
    if ( fscanf( file, "%ld/", position ) != 1 )
        return 0;
    c = getc( file );
    if ( c != '/' ) {
        ungetc( c, file );
        if ( fscanf( file, "%ld/", normal ) != 1 ) /* {{the uv, not used|uv は使わない}} */
            return 0;
    }
    return fscanf( file, "%ld", normal ) == 1;
}

/* {{A face as a fan of triangles around its last corner|面を、最後の頂点を要とする扇形の三角形に}} */
void read_face( FILE *file, const struct list *v, const struct list *vn )
{
    long position[MOST_CORNERS], normal[MOST_CORNERS];
    int corners = 0, i, k;

    while ( corners < MOST_CORNERS && read_corner( file, &position[corners], &normal[corners] ) )
        corners++;
    for ( i = 0; i + 2 < corners; i++ )
        for ( k = 0; k < 3; k++ ) {
            int corner = k < 2 ? i + k : corners - 1;

            append_copy( &vertices, v, position[corner] );
            append_copy( &normals, vn, normal[corner] );
        }
}

void read_obj( const char *name )
{
    FILE *file = fopen( name, "r" );
    struct list v = { NULL, 0, 0 }, vn = { NULL, 0, 0 };
    char word[100];
    double x, y, z;
    int mesh = -1;

    if ( file == NULL ) {
        fprintf( stderr, "{{%s is not here: it was exported together with this program|%s がない：このプログラムと一緒に書き出したファイル}}\n", name );
        exit( 1 );
    }
    while ( fscanf( file, "%99s", word ) == 1 ) {
        if ( strcmp( word, "v" ) == 0 && fscanf( file, "%lf %lf %lf", &x, &y, &z ) == 3 )
            append( &v, x, y, z );
        else if ( strcmp( word, "vn" ) == 0 && fscanf( file, "%lf %lf %lf", &x, &y, &z ) == 3 )
            append( &vn, x, y, z );
        else if ( strcmp( word, "f" ) == 0 )
            read_face( file, &v, &vn );
        else {
            if ( strcmp( word, "o" ) == 0 && mesh + 1 < meshes )
                first[++mesh] = vertices.count;
            skip_line( file );
        }
    }
    while ( mesh < meshes )
        first[++mesh] = vertices.count;
    fclose( file );
    free( v.numbers );
    free( vn.numbers );
}
)c";

const std::string_view glut_window = R"c(
/* ---- {{The window|ウィンドウ}} ---- */

void display( void )
{
    draw_scene();
    glutSwapBuffers();
}

void reshape( int width, int height )
{
    glViewport( 0, 0, width, height );
    aspect = (double) width / ( height > 0 ? height : 1 );
}

/* {{Turns the eye around the target|注視点のまわりに視点を回す}} */
void orbit( double degrees, double degrees_up )
{
    double offset[3], axis[3], turned[3], upright[3];
    int i;

    for ( i = 0; i < 3; i++ ) {
        offset[i] = eye[i] - target[i];
        upright[i] = up[i];
    }
    normalize( upright );
    cross( axis, upright, offset );
    normalize( axis );
    load_identity();
    rotate( degrees, upright[0], upright[1], upright[2] );
    rotate( degrees_up, -axis[0], -axis[1], -axis[2] );
    for ( i = 0; i < 3; i++ )
        turned[i] = matrix[i] * offset[0] + matrix[4 + i] * offset[1] + matrix[8 + i] * offset[2];
    if ( fabs( dot( turned, upright ) ) > 0.99 * sqrt( dot( turned, turned ) ) )
        return;
    for ( i = 0; i < 3; i++ )
        eye[i] = target[i] + turned[i];
    glutPostRedisplay();
}

void approach( double factor )
{
    int i;

    for ( i = 0; i < 3; i++ )
        eye[i] = target[i] + factor * ( eye[i] - target[i] );
    glutPostRedisplay();
}

int last_x, last_y; /* {{where the mouse was|直前のマウスの位置}} */

void mouse( int button, int state, int x, int y )
{
    last_x = x;
    last_y = y;
    if ( state == GLUT_DOWN && ( button == 3 || button == 4 ) ) /* {{the wheel|ホイール}} */
        approach( button == 3 ? 0.9 : 1 / 0.9 );
}

void motion( int x, int y )
{
    orbit( 0.5 * ( last_x - x ), 0.5 * ( y - last_y ) );
    last_x = x;
    last_y = y;
}

int light_turns = 0, model_turns = 0;

void timer( int value )
{
    if ( light_turns )
        light_angle += 1.0;
    if ( model_turns )
        model_angle += 1.0;
    glutPostRedisplay();
    if ( light_turns || model_turns )
        glutTimerFunc( 20, timer, value );
}

void start_or_stop( int *turns )
{
    int timer_runs = light_turns || model_turns;

    *turns = !*turns;
    if ( !timer_runs )
        timer( 0 );
}

/* {{In the format PPM: a head, then the rows from the top|PPM 形式：見出しに続けて上の行から}} */
void save_picture( void )
{
    int width = glutGet( GLUT_WINDOW_WIDTH ), height = glutGet( GLUT_WINDOW_HEIGHT ), row;
    unsigned char *pixels = malloc( 3 * (size_t) width * (size_t) height );
    FILE *file = fopen( PICTURE_NAME, "wb" );

    if ( pixels != NULL && file != NULL ) {
        draw_scene();
        glPixelStorei( GL_PACK_ALIGNMENT, 1 );
        glReadPixels( 0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels );
        fprintf( file, "P6\n%d %d\n255\n", width, height );
        for ( row = height - 1; row >= 0; row-- )
            fwrite( pixels + 3 * (size_t) width * (size_t) row, 3, (size_t) width, file );
        printf( "{{%s is saved|%s に保存した}}\n", PICTURE_NAME );
    } else {
        fprintf( stderr, "{{%s cannot be saved|%s に保存できない}}\n", PICTURE_NAME );
    }
    if ( file != NULL )
        fclose( file );
    free( pixels );
}

void keyboard( unsigned char key, int x, int y )
{
    (void) x;
    (void) y;
    switch ( key ) {
    case 'a':
        start_or_stop( &light_turns );
        break;
    case 'm':
        start_or_stop( &model_turns );
        break;
    case 's':
        save_picture();
        break;
    case 'q':
    case 27: /* Esc */
        exit( 0 );
    }
}

int main( int argc, char *argv[] )
{
    read_obj( OBJ_NAME );
    glutInit( &argc, argv );
    glutInitDisplayMode( GLUT_RGB | GLUT_DOUBLE | GLUT_DEPTH );
    glutInitWindowSize( 512, 512 );
    glutCreateWindow( argv[0] );
    set_state();
    glutDisplayFunc( display );
    glutReshapeFunc( reshape );
    glutMouseFunc( mouse );
    glutMotionFunc( motion );
    glutKeyboardFunc( keyboard );
    glutMainLoop();
    return 0;
}
)c";

}  // namespace cg
