#include <GL/glut.h>

enum { KEY_LIGHT, FILL_LIGHT, BACK_LIGHT, LIGHTS };

GLfloat positions[LIGHTS][4] = {
  { 10.0, 10.0, 10.0, 1.0 },
  { -5.0,  2.0,  4.0, 1.0 },
  {  0.0,  4.0, -8.0, 1.0 }
};
GLfloat colors[][4] = { { 1, 1, 1, 1 }, { 0.3, 0.3, 0.4, 1 }, { 0.2, 0.2, 0.1, 1 } };
GLfloat *specular[] = { colors[0], colors[1] };

void set_lights()
{
  int i;
  for (i = 0; i < LIGHTS; i++) {
    glEnable(GL_LIGHT0 + i);
    glLightfv(GL_LIGHT0 + i, GL_POSITION, positions[i]);
    glLightfv(GL_LIGHT0 + i, GL_DIFFUSE, colors[i]);
    if (i < 2)
      glLightfv(GL_LIGHT0 + i, GL_SPECULAR, specular[i]);
  }
  glLightfv(GL_LIGHT5, GL_DIFFUSE, colors[KEY_LIGHT]);
  glDisable(GL_LIGHT0 + FILL_LIGHT);
}

void display()
{
  GLfloat diffuse[] = { 0.1, 0.6, 0.3, 1.0 };
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  gluLookAt(0, 2, 6, 0, 0, 0, 0, 1, 0);
  set_lights();
  glMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
  glutSolidSphere(1.5, 40, 20);
  glutSwapBuffers();
}

void reshape(int width, int height)
{
  glViewport(0, 0, width, height);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  gluPerspective(45, width / (float)height, 0.5, 50);
}

int main(int argc, char *argv[])
{
  glutInit(&argc, argv);
  glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
  glutCreateWindow("three lights");
  glEnable(GL_LIGHTING);
  glEnable(GL_DEPTH_TEST);
  glutDisplayFunc(display);
  glutReshapeFunc(reshape);
  glutMainLoop();
  return 0;
}
