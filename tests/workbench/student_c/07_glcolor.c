#include <GL/glut.h>

void display(void)
{
    GLfloat p[4] = { 4, 4, 4, 1 };
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, p);
    glLightf(GL_LIGHT0, GL_DIFFUSE, 0.5);
    glColor3ub(255, 51, 0);
    glMaterialf(GL_FRONT, GL_SHININESS, 200);
    glMaterialf(GL_BACK, GL_SHININESS, 10);
    glMaterialf(GL_FRONT, GL_SPECULAR, 1.0);
    glutWireTorus(0.3, 0.7, 20, 40);
    glFlush();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_RGB);
    glutCreateWindow("color");
    glMatrixMode(GL_PROJECTION);
    gluPerspective(40, 1, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}
