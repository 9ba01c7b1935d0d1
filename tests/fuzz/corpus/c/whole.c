float a; int on = 1;
void set(float *v, float x) { v[0] = x; *(v + 1) = -x / 2; }
void display(void) {
  static float p[4] = { 0, 0, 0, 1 };
  a += 1; set(p, 3);
  glLoadIdentity(); gluLookAt(3,4,5, 0,0,0, 0,1,0);
  if (on) glLightfv(GL_LIGHT0, GL_POSITION, p); else glDisable(GL_LIGHT0);
  glPushMatrix(); glTranslatef(1,0,0); glRotatef(a, 0,1,0); glScalef(2,2,2);
  glutSolidTorus(0.3, 0.7, 20, 40); glPopMatrix();
  glColor3ub(255, 0, 1); glBegin(GL_TRIANGLES); glEnd();
}
void key(unsigned char k, int x, int y) { switch (k) { case 'a': on = !on; break; default: ; } }
int main(int c, char **v) {
  glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);
  glMatrixMode(GL_PROJECTION); glOrtho(-1,1,-1,1,-1,1); glMatrixMode(GL_MODELVIEW);
  glutDisplayFunc(display); glutKeyboardFunc(key); glutMainLoop();
}
