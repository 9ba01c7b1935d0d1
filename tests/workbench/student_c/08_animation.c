#include <GL/glut.h>
#include <math.h>

double t = 0.0, angle = 0.0, size = 2.0;
int red_on = 1, frames;
float light_pos[4] = { 5.0, 5.0, 0.0, 1.0 };
float fixed_pos[4] = { -5.0, 5.0, 5.0, 1.0 };
float red[] = { 1.0, 0.0, 0.0, 1.0 }, green[] = { 0.0, 1.0, 0.0, 1.0 };

void display(void)
{
    frames++;
    light_pos[0] = 5.0 * cos(t);
    light_pos[2] = 5.0 * sin(t);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    gluLookAt(0.0, 3.0, 8.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
    glLightfv(GL_LIGHT0, GL_POSITION, light_pos);
    glLightfv(GL_LIGHT1, GL_POSITION, fixed_pos);
    if (red_on)
        glMaterialfv(GL_FRONT, GL_DIFFUSE, red);
    else
        glMaterialfv(GL_FRONT, GL_DIFFUSE, green);
    glTranslatef(0.0, frames * 0.01, 0.0);
    glRotated(angle, 0.0, 1.0, 0.0);
    glRotated(20.0, 1.0, 0.0, 0.0);
    angle = angle + 1.0;
    glutSolidTeapot(size);
    glutSwapBuffers();
}

void idle(void)
{
    t += 0.01;
    glutPostRedisplay();
}

void keyboard(unsigned char key, int x, int y)
{
    if (key == 'r') red_on = !red_on;
}

int main(int argc, char *argv[])
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH);
    glutCreateWindow("animation");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHT1);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(30.0, 1.0, 1.0, 100.0);
    glMatrixMode(GL_MODELVIEW);
    glutDisplayFunc(display);
    glutIdleFunc(idle);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
