/* OpenGL's lighting, computed by the program: The OpenGL Graphics System 2.1, section 2.14.1 (one side). */

struct source {
    GLfloat position[ 4 ], ambient[ 4 ], diffuse[ 4 ], specular[ 4 ], direction[ 4 ];
    GLfloat cutoff, exponent, k_0, k_1, k_2;
};

static struct source sources[ 8 ];
static int source_count;
static GLfloat model_ambient[ 4 ], k_a[ 4 ], k_d[ 4 ], k_s[ 4 ], emission[ 4 ], shininess, modelview[ 16 ];
static GLboolean local_viewer, normalize_normals, rescale_normals;

static double dot( const double a[ 3 ], const double b[ 3 ] )
{
    return a[ 0 ] * b[ 0 ] + a[ 1 ] * b[ 1 ] + a[ 2 ] * b[ 2 ];
}

static void normalize( double v[ 3 ] )
{
    double length = sqrt( dot( v, v ) );

    if ( length > 0.0 ) {
        v[ 0 ] /= length;
        v[ 1 ] /= length;
        v[ 2 ] /= length;
    }
}

/* What glLight, glMaterial and glLightModel said; before each mesh. Positions come back in eye coordinates. */
static void read_lights( void )
{
    int i;

    source_count = 0;
    for ( i = 0; i < 8; i++ ) {
        GLenum light = ( GLenum ) ( GL_LIGHT0 + i );
        struct source *s = &sources[ source_count ];

        if ( !glIsEnabled( light ) )
            continue;
        glGetLightfv( light, GL_POSITION, s->position );
        glGetLightfv( light, GL_AMBIENT, s->ambient );
        glGetLightfv( light, GL_DIFFUSE, s->diffuse );
        glGetLightfv( light, GL_SPECULAR, s->specular );
        glGetLightfv( light, GL_SPOT_DIRECTION, s->direction );
        glGetLightfv( light, GL_SPOT_CUTOFF, &s->cutoff );
        glGetLightfv( light, GL_SPOT_EXPONENT, &s->exponent );
        glGetLightfv( light, GL_CONSTANT_ATTENUATION, &s->k_0 );
        glGetLightfv( light, GL_LINEAR_ATTENUATION, &s->k_1 );
        glGetLightfv( light, GL_QUADRATIC_ATTENUATION, &s->k_2 );
        source_count++;
    }
    glGetFloatv( GL_LIGHT_MODEL_AMBIENT, model_ambient );
    glGetBooleanv( GL_LIGHT_MODEL_LOCAL_VIEWER, &local_viewer );
    glGetMaterialfv( GL_FRONT, GL_AMBIENT, k_a );
    glGetMaterialfv( GL_FRONT, GL_DIFFUSE, k_d );
    glGetMaterialfv( GL_FRONT, GL_SPECULAR, k_s );
    glGetMaterialfv( GL_FRONT, GL_EMISSION, emission );
    glGetMaterialfv( GL_FRONT, GL_SHININESS, &shininess );
    glGetFloatv( GL_MODELVIEW_MATRIX, modelview );
    normalize_normals = glIsEnabled( GL_NORMALIZE );
    rescale_normals = glIsEnabled( GL_RESCALE_NORMAL );
}

/* The point p and the normal n in eye coordinates: M vertex, and the inverse transposed of M times normal. */
static void to_eye( const GLfloat vertex[ 3 ], const GLfloat normal[ 3 ], double p[ 3 ], double n[ 3 ] )
{
    const GLfloat *m = modelview;
    double cofactor[ 3 ][ 3 ], determinant = 0.0, length;
    int row, column;

    for ( column = 0; column < 3; column++ )
        for ( row = 0; row < 3; row++ ) {
            int c1 = 4 * ( ( column + 1 ) % 3 ), c2 = 4 * ( ( column + 2 ) % 3 );
            int r1 = ( row + 1 ) % 3, r2 = ( row + 2 ) % 3;

            cofactor[ column ][ row ] = ( double ) m[ c1 + r1 ] * m[ c2 + r2 ] - ( double ) m[ c1 + r2 ] * m[ c2 + r1 ];
        }
    for ( row = 0; row < 3; row++ )
        determinant += m[ row ] * cofactor[ 0 ][ row ];
    for ( row = 0; row < 3; row++ ) {
        p[ row ] = ( double ) m[ row ] * vertex[ 0 ] + ( double ) m[ 4 + row ] * vertex[ 1 ]
                 + ( double ) m[ 8 + row ] * vertex[ 2 ] + m[ 12 + row ];
        n[ row ] = ( cofactor[ 0 ][ row ] * normal[ 0 ] + cofactor[ 1 ][ row ] * normal[ 1 ]
                   + cofactor[ 2 ][ row ] * normal[ 2 ] ) / determinant;
    }
    if ( rescale_normals ) {
        length = sqrt( dot( cofactor[ 2 ], cofactor[ 2 ] ) ) / fabs( determinant );
        for ( row = 0; row < 3; row++ )
            n[ row ] /= length;
    }
    if ( normalize_normals )
        normalize( n );
}

/* The colour of a vertex. */
static const GLfloat *shade( const GLfloat vertex[ 3 ], const GLfloat normal[ 3 ] )
{
    static GLfloat color[ 3 ];
    double p[ 3 ], n[ 3 ], v[ 3 ], l[ 3 ], h[ 3 ], sum[ 3 ];
    int i, k;

    to_eye( vertex, normal, p, n );
    for ( k = 0; k < 3; k++ ) {
        v[ k ] = local_viewer ? -p[ k ] : k == 2;
        sum[ k ] = emission[ k ] + ( double ) model_ambient[ k ] * k_a[ k ];
    }
    normalize( v );
    for ( i = 0; i < source_count; i++ ) {
        const struct source *s = &sources[ i ];
        double r, n_dot_l, n_dot_h, highlight = 0.0, fade = 1.0;

        for ( k = 0; k < 3; k++ )
            l[ k ] = s->position[ 3 ] != 0.0f ? s->position[ k ] / s->position[ 3 ] - p[ k ] : s->position[ k ];
        r = sqrt( dot( l, l ) );
        if ( s->position[ 3 ] != 0.0f )
            fade = 1.0 / ( s->k_0 + s->k_1 * r + s->k_2 * r * r );
#ifndef LONG_LIGHT_VECTOR
        normalize( l );
#endif
        if ( s->cutoff < 180.0f ) {
            double axis[ 3 ], c;

            for ( k = 0; k < 3; k++ )
                axis[ k ] = -s->direction[ k ];
            normalize( axis );
            c = dot( l, axis );
            fade *= c >= cos( s->cutoff * 3.14159265358979323846 / 180.0 ) ? pow( c, s->exponent ) : 0.0;
        }
        n_dot_l = dot( n, l ) > 0.0 ? dot( n, l ) : 0.0;
        for ( k = 0; k < 3; k++ )
            h[ k ] = l[ k ] + v[ k ];
        normalize( h );
        n_dot_h = dot( n, h ) > 0.0 ? dot( n, h ) : 0.0;
#ifndef NO_GATE
        if ( n_dot_l > 0.0 )
            highlight = pow( n_dot_h, shininess );
#else
        highlight = pow( n_dot_h, shininess );
#endif
        for ( k = 0; k < 3; k++ )
            sum[ k ] += fade * ( ( double ) s->ambient[ k ] * k_a[ k ] + n_dot_l * s->diffuse[ k ] * k_d[ k ]
                               + highlight * s->specular[ k ] * k_s[ k ] );
    }
    for ( k = 0; k < 3; k++ )
        color[ k ] = ( GLfloat ) sum[ k ];
    return color;
}
