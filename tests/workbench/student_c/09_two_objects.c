#include <GL/glut.h>

GLfloat lightPosition[4];
GLfloat matA[4], matB[4];

void makeColor(GLfloat color[], float r, float g, float b) {
  color[0] = r;
  color[1] = g;
  *(color + 2) = b;
  color[3] = 1.0f;
}

void display() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glTranslatef(0, 0, -5);
  lightPosition[1] = 3; lightPosition[3] = 1;
  glLightfv(GL_LIGHT0, GL_POSITION, lightPosition);

  glPushMatrix();
    glTranslatef(-1, 0, 0);
    glRotatef(90, 1, 0, 0);
    glRotatef(30, 0, 1, 0);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, matA);
    glutSolidTorus(0.15, 0.35, 20, 40);
  glPopMatrix();

  glPushMatrix();
    glTranslatef(1, 0, 0);
    glScalef(2, 2, 2);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, matB);
    glutSolidCube(0.5);
  glPopMatrix();
  glutSwapBuffers();
}

int main(int argc, char** argv) {
  glutInit(&argc, argv);
  glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE | GLUT_DEPTH);
  glutCreateWindow("two");
  makeColor(matA, 1, 0.5, 0.25);
  makeColor(matB, 0, 0.5, 1);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_NORMALIZE);
  glEnable(GL_COLOR_MATERIAL);
  glColorMaterial(GL_FRONT, GL_SPECULAR);
  glColor3d(0.5, 0.5, 0.5);
  glMatrixMode(GL_PROJECTION);
  glOrtho(-2, 2, -2, 2, 1, 10);
  glutDisplayFunc(display);
  glutMainLoop();
  return 0;
}
