glClearColor(0,0,0,1);
glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 128.0);
/* shadebench import:
 * lights: 0 -> 2
 * objects.0.model: "" -> "torus"
 * material.n: 128 -> 500
 * shading.reflection: "half-vector" -> "reflection-vector"
 */
