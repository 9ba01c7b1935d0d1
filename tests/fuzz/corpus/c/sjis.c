GLfloat p[]={1,1,1,0}; // •\
void init(){ glLightfv(GL_LIGHT1, GL_POSITION, p); glEnable(GL_LIGHT1);
 glLightf(GL_LIGHT1, GL_LINEAR_ATTENUATION, 1.0/3); }
#if 0
{{{
#endif
#define R(x) ((x)*M_PI/180)
void display(){ glTranslatef(0,sin(R(30)),-5); glutSolidSphere(1,20,20); }
