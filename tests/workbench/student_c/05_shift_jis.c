#include <GL/glut.h>
// 光源の表
// ソ
GLfloat position[] = { 1.0, 2.0, 3.0, 1.0 }; // 位置を表
GLfloat color[] = { 0.5, 0.5, 0.75, 1.0 };   /* 色の表*/

void scene(void)
{
	glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	glLoadIdentity();
	gluLookAt(0.0, 0.0, 10.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
	glLightfv(GL_LIGHT0, GL_POSITION, position);
	// 拡散光能
	glLightfv(GL_LIGHT0, GL_DIFFUSE, color);
	glutSolidCube(2.0);
	glutSwapBuffers();
}

int main(int argc, char *argv[])
{
	glutInit(&argc, argv);
	glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH);
	glutCreateWindow("課題の表");
	glEnable(GL_DEPTH_TEST);
	glEnable(GL_LIGHTING);
	glEnable(GL_LIGHT0);
	glMatrixMode(GL_PROJECTION);
	glLoadIdentity();
	gluPerspective(25.0, 1.0, 1.0, 30.0);
	glMatrixMode(GL_MODELVIEW);
	glutDisplayFunc(scene);
	glutMainLoop();
	return 0;
}
