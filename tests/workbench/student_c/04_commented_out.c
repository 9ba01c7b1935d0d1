#include <GL/glut.h>
//#define OLD_LIGHT
#define NEW_LIGHT

static float light[4];
static float brass_a[] = {0.329412, 0.223529, 0.027451, 1.0},
             brass_d[] = {0.780392, 0.568627, 0.113725, 1.0},
             brass_s[] = {0.992157, 0.941176, 0.807843, 1.0};

void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT|GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    // gluLookAt(1, 2, 3, 0, 0, 0, 0, 1, 0);
    gluLookAt(0, 0, 8, 0, 0, 0, 0, 1, 0);
#ifdef OLD_LIGHT
    light[0] = -1; light[1] = -1; light[2] = -1; light[3] = 0;
#else
    light[0] = 2;
    light[1] = 4;   // light[1] = 40;
    light[2] = 6;
    light[3] = 1;
#endif
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    /* glLightfv(GL_LIGHT1, GL_POSITION, light);
       glEnable(GL_LIGHT1); */
#if 0
    glEnable(GL_LIGHT2);
    this is not C at all
#endif
    glMaterialfv(GL_FRONT, GL_AMBIENT, brass_a);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, brass_d);
    glMaterialfv(GL_FRONT, GL_SPECULAR, brass_s);
    //glMaterialf(GL_FRONT, GL_SHININESS, 5.0);
    glMaterialf(GL_FRONT, GL_SHININESS, 27.8974);
    glutSolidTorus(0.6, 1.4, 24, 48); // glutSolidTeapot(1.0);
    glutSwapBuffers();
}

int main(int argc, char *argv[])
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE|GLUT_RGBA|GLUT_DEPTH);
    glutCreateWindow("brass");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
#if defined(NEW_LIGHT) && !defined(OLD_LIGHT)
    glEnable(GL_LIGHT0);
#endif
    glMatrixMode(GL_PROJECTION);
    gluPerspective(60.0, 1.0, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}
