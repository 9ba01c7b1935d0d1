#include <GL/glut.h>
#include <stdlib.h>
#include "mylib.h"

typedef struct { float x, y, z, w; } Vec4;
struct material { float diffuse[4]; float shininess; } gold = { { 0.75, 0.6, 0.2, 1 }, 51.2 };
Vec4 p = { 1, 2, 3, 1 };
GLfloat good[] = { 2, 2, 2, 1 };
GLfloat three[] = { 0.5, 0.25, 0.125 };
GLfloat random_color[4];

void setLight(int number, GLfloat *position)
{
    glLightfv(GL_LIGHT0 + number, GL_POSITION, position);
    glEnable(GL_LIGHT0 + number);
}

void drawAxes(void)
{
    glBegin(GL_LINES);
    glVertex3f(0, 0, 0); glVertex3f(1, 0, 0);
    glEnd();
}

void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    gluLookAt(0, 0, 4, 0, 0, 0, 0, 1, 0);
    setLight(0, good);
    setLight(1, (GLfloat *)&p);
    setLight(9, good);
    random_color[0] = rand() / (float)RAND_MAX;
    glMaterialfv(GL_FRONT, GL_AMBIENT, random_color);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, gold.diffuse);
    glMaterialf(GL_FRONT, GL_SHININESS, gold.shininess);
    glMaterialfv(GL_FRONT, GL_SPECULAR, three);
    glLightfv(GL_LIGHT0, GL_DIFUSE, good);
    glLightfv(GL_LIGHT0, GL_SPECULAR, good)
    glEnable(GL_FOG);
    glLightf(GL_LIGHT0,　GL_SPOT_CUTOFF, 100);
    std::cout << "hello";
    drawAxes();
    glutSwapBuffers();
}

int main(int argc, char *argv[])
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH);
    glutCreateWindow("?");
    glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(200, 1, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}
