GLfloat p[] = { 1, 2.5, 0x3, 1 }, q[2][4] = {{1,2,3,0}};
#define N 2
gluLookAt(0,0,5, 0,0,0, 0,1,0);
for (int i = 0; i < N; i++) { glEnable(GL_LIGHT0 + i); glLightfv(GL_LIGHT0 + i, GL_POSITION, q[i]); }
glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, p);
glMaterialf(GL_FRONT, GL_SHININESS, 1e1f);
