#include "workbench/glut_program.h"

namespace cg {

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
