#include <GL/glut.h>
#include <math.h>

#define LIGHT_HEIGHT (2.5 * 2)
#define RAD(deg) ((deg) * M_PI / 180.0)
#define SHININESS 0x40

const static double radius = 4.0;

void init(void) {
    const float spot_position[] = { (float)(radius * sin(RAD(30))), LIGHT_HEIGHT, radius * cos(RAD(60)), 1 };
    const float spot_direction[] = { -0.5f, -1.f, -.5f };
    float ambient[4] = { 0.1f, 0.1f };
    glShadeModel(GL_FLAT);
    glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST); glEnable(GL_NORMALIZE);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 2, 50 + 50);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 0, sqrt(25), 0, 0, 0, 0, 1, 0);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1.0);
    glLightfv(GL_LIGHT0, GL_POSITION, spot_position);
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, spot_direction);
    glLighti(GL_LIGHT0, GL_SPOT_CUTOFF, 90 / 2);
    glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, pow(2, 3));
    glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1.5);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1 / 4);
    glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 1 / 4.0);
}

void display(void) {
    float n = SHININESS;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glTranslated(0.5, -(1 + 1) / 2.0, 0);
    glRotatef(45, 0, 0, 1);
    glRotatef(-30, 0, 1, 0);
    glMaterialf(GL_FRONT, GL_SHININESS, n / 2);
    glutSolidTorus(0.3, 0.7, 32, 64);
    glPopMatrix();
    glFlush();
}

int main(int argc, char **argv) {
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(400, 400);
    glutCreateWindow("torus");
    init();
    glutDisplayFunc(display);
    glutMainLoop();
}
