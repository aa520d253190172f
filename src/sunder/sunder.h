/* Sunder for C, C99 or newer, and for whatever can call C. What sunder.hpp says of a function holds
   for the one here that is named like it: units, ranges, threads.

   A function that can fail returns a sunder_status. sunder_message() then says why, in one
   sentence. A pointer that is handed over must not be null unless it says so. */
#ifndef SUNDER_H
#define SUNDER_H

#include <sunder/export.h>

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How a function ended. */
typedef enum sunder_status {
    SUNDER_OK = 0,     /* Well. */
    SUNDER_INPUT = 1,  /* What was asked for makes no sense. */
    SUNDER_MEMORY = 2, /* There is not enough memory, of the machine or of the GPU. */
    SUNDER_DEVICE = 3, /* The GL context is too old or lost, or its driver failed. */
    SUNDER_BUG = 4     /* A fault of Sunder's: please report the message. */
} sunder_status;

/* Sides of a body, one or several, joined by |. */
enum {
    SUNDER_LEFT = 1,   /* -x */
    SUNDER_RIGHT = 2,  /* +x */
    SUNDER_BOTTOM = 4, /* -y */
    SUNDER_TOP = 8,    /* +y */
    SUNDER_BACK = 16,  /* -z */
    SUNDER_FRONT = 32  /* +z */
};

/* All bodies and objects, of sunder_push. */
#define SUNDER_EVERY_BODY (-1)

/* A world before it is made. */
typedef struct sunder_desc sunder_desc;
/* A world. */
typedef struct sunder_world sunder_world;
/* A GL context of the host's. */
typedef struct sunder_device sunder_device;
/* The mesh that is seen of a world, on the GPU. */
typedef struct sunder_surface sunder_surface;

/* A body: sunder::BodyDesc. sunder_body_default() first. */
typedef struct sunder_body {
    int material;          /* What sunder_desc_add_material() gave. */
    double size[3];        /* m. */
    int cells[3];          /* Along x, y, z. */
    double position[3];    /* m, world: centre of the bottom face. */
    double orientation[4]; /* A unit quaternion: w, x, y, z. */
    unsigned anchors;      /* Sides that never move. */
    int present;           /* 0: not there until sunder_world_add_body(). */
} sunder_body;

/* The shape of an object. */
typedef enum sunder_shape {
    SUNDER_SPHERE = 0, /* A ball. */
    SUNDER_BOX = 1,    /* A block. */
    SUNDER_CAPSULE = 2 /* A cylinder along y with round ends. */
} sunder_shape;

/* How an object moves. */
typedef enum sunder_motion {
    SUNDER_FREE = 0,     /* By what pushes it. */
    SUNDER_FIXED = 1,    /* Never. */
    SUNDER_KINEMATIC = 2 /* By sunder_world_set_kinematic() alone. */
} sunder_motion;

/* A rigid object: sunder::Object. sunder_object_default() first. */
typedef struct sunder_object {
    sunder_shape shape; /* Its shape. */
    double size[3];     /* m: a box's edges; else x the diameter and, of a capsule, y the length. */
    double mass;        /* kg. */
    sunder_motion motion;  /* How it moves. */
    int present;           /* Whether it is there as the world begins. */
    double position[3];    /* m, world: its centre. */
    double orientation[4]; /* A unit quaternion: w, x, y, z. */
    double velocity[3];    /* m/s. */
    double friction;       /* Coulomb's. */
    double restitution;    /* 0 to 1. */
} sunder_object;

/* A push: sunder::Push. sunder_push_default() first. */
typedef struct sunder_push {
    int body;           /* An index, or SUNDER_EVERY_BODY: objects, too. */
    double at[3];       /* m, world; of one body: at rest. */
    double radius;      /* m. */
    double velocity[3]; /* m/s; or */
    double impulse[3];  /* N s, of one body; or */
    double force[3];    /* N, of one body. */
    double outward;     /* m/s, away from `at`, of every body. */
    int falloff;        /* Whether it lessens towards the rim, of every body. */
    double duration;    /* s. */
    double delay;       /* s. */
} sunder_push;

/* Something that happened: sunder::Incident. */
typedef struct sunder_incident {
    int broke;       /* 1: a bond gave way. 0: something hit a cell. */
    double time;     /* s. */
    double place[3]; /* m, world. */
    double impulse;  /* N s. */
    int body, material, other_body, other_material, object; /* Indices, or -1. */
} sunder_incident;

/* What a ray meets: sunder::RayHit. */
typedef struct sunder_ray_hit {
    double distance;            /* m. */
    double place[3];            /* m, world. */
    double normal[3];           /* Of length 1, outwards. */
    int body, material, object; /* Indices, or -1. */
    double rest_place[3];       /* m, world, at rest. */
} sunder_ray_hit;

/* Triangles of one material: sunder::gl::Range. */
typedef struct sunder_range {
    int material;    /* Index. */
    int inside;      /* 1: what a break bares. */
    int transparent; /* 1: light passes. */
    int count;       /* Indices. */
    size_t offset;   /* Bytes, in the index buffer. */
} sunder_range;

/* Vertices of one body: sunder::gl::VertexRange. */
typedef struct sunder_vertex_range {
    int body;  /* Index. */
    int first; /* Its first vertex. */
    int count; /* How many there are. */
} sunder_vertex_range;

/* What a vertex shader of the host's reads: sunder::gl::VertexTexture. */
typedef struct sunder_vertex_texture {
    const char* sampler; /* The name of its uniform. */
    unsigned texture;    /* Of the target GL_TEXTURE_BUFFER. */
} sunder_vertex_texture;

/* The version of the library. Any of the pointers may be null. */
SUNDER_API void sunder_version(int* major, int* minor, int* patch);
/* Why the last function failed that was called on this thread; valid until the next that fails.
   Never null. */
SUNDER_API const char* sunder_message(void);

/* A body with the values that sunder::BodyDesc has. */
SUNDER_API sunder_body sunder_body_default(void);
/* An object with the values that sunder::Object has: a ball. */
SUNDER_API sunder_object sunder_object_default(void);
/* A push with the values that sunder::Push has. */
SUNDER_API sunder_push sunder_push_default(void);

/* An empty description; null: there is no memory. */
SUNDER_API sunder_desc* sunder_desc_create(void);
/* The scene that comes with Sunder by this name; null where it fails. */
SUNDER_API sunder_desc* sunder_desc_preset(const char* name);
/* What a scene file says; null where it fails. */
SUNDER_API sunder_desc* sunder_desc_load(const char* path);
/* Null does nothing. */
SUNDER_API void sunder_desc_destroy(sunder_desc* desc);
/* Adds a material that comes with Sunder, or that a file says; `*index`: its number. */
SUNDER_API sunder_status sunder_desc_add_material(sunder_desc* desc, const char* name_or_path,
                                                  int* index);
/* Sets a number of a material by its name in material files, such as "young_modulus". */
SUNDER_API sunder_status sunder_desc_set_material(sunder_desc* desc, int material, const char* key,
                                                  double value);
/* `*index`, which may be null: its number. */
SUNDER_API sunder_status sunder_desc_add_body(sunder_desc* desc, const sunder_body* body,
                                              int* index);
/* `*index`, which may be null: its number. */
SUNDER_API sunder_status sunder_desc_add_object(sunder_desc* desc, const sunder_object* object,
                                                int* index);
/* m/s^2. */
SUNDER_API void sunder_desc_set_gravity(sunder_desc* desc, double x, double y, double z);
/* Whether there is a floor at y = 0. */
SUNDER_API void sunder_desc_set_ground(sunder_desc* desc, int ground);
/* Whether pieces push each other. */
SUNDER_API void sunder_desc_set_contact(sunder_desc* desc, int contact);
/* s, one substep. */
SUNDER_API void sunder_desc_set_substep(sunder_desc* desc, double seconds);
/* Of the scatter of strengths. */
SUNDER_API void sunder_desc_set_seed(sunder_desc* desc, uint64_t seed);

/* Makes a world. `device`: null: on the CPU. `solver`: null: the default. Null where it fails. */
SUNDER_API sunder_world* sunder_world_create(const sunder_desc* desc, sunder_device* device,
                                             const char* solver);
/* Null does nothing. */
SUNDER_API void sunder_world_destroy(sunder_world* world);
/* Lets time pass, s. */
SUNDER_API sunder_status sunder_world_step(sunder_world* world, double seconds);
/* Waits until all of it is done. */
SUNDER_API sunder_status sunder_world_finish(sunder_world* world);
/* s, since the world began. */
SUNDER_API double sunder_world_time(const sunder_world* world);
/* s: of the state that rays, pieces and broken bonds are told of; late on a GPU. */
SUNDER_API double sunder_world_look_time(const sunder_world* world);
/* Pushes. */
SUNDER_API sunder_status sunder_world_push(sunder_world* world, const sunder_push* push);
/* Throws an object. Three numbers each; `spin` may be null. */
SUNDER_API sunder_status sunder_world_throw(sunder_world* world, int object, const double* from,
                                            const double* velocity, const double* spin);
/* Puts a kinematic object somewhere. Three numbers each, four of the orientation; orientation,
   velocity and spin may be null. */
SUNDER_API sunder_status sunder_world_set_kinematic(sunder_world* world, int object,
                                                    const double* position,
                                                    const double* orientation,
                                                    const double* velocity, const double* spin);
/* Takes an object away. */
SUNDER_API sunder_status sunder_world_remove_object(sunder_world* world, int object);
/* Puts a body there that is not: whole, at rest where its description has it. */
SUNDER_API sunder_status sunder_world_add_body(sunder_world* world, int body);
/* Takes a body away, and all its pieces, until it is added again. */
SUNDER_API sunder_status sunder_world_remove_body(sunder_world* world, int body);
/* Lets go of a body's anchors. */
SUNDER_API sunder_status sunder_world_release_anchors(sunder_world* world, int body);
/* Makes the world larger: what `desc` has beyond it at the ends of its lists. */
SUNDER_API sunder_status sunder_world_extend(sunder_world* world, const sunder_desc* desc);
/* All of it as bytes; `*bytes` is valid until the next call of this function with this world. */
SUNDER_API sunder_status sunder_world_save(sunder_world* world, const void** bytes, size_t* size);
/* Goes on from there. */
SUNDER_API sunder_status sunder_world_restore(sunder_world* world, const void* bytes, size_t size);
/* What has happened since the last call; `*incidents` is valid until the next. How many. */
SUNDER_API size_t sunder_world_incidents(sunder_world* world, const sunder_incident** incidents);
/* Whether a ray meets something: 1 or 0. Three numbers each. */
SUNDER_API int sunder_world_cast_ray(const sunder_world* world, const double* origin,
                                     const double* direction, sunder_ray_hit* hit);
/* How many bonds have broken. */
SUNDER_API sunder_status sunder_world_broken_bonds(const sunder_world* world, int* broken);
/* How many pieces there are. */
SUNDER_API sunder_status sunder_world_pieces(const sunder_world* world, int* pieces);
/* A fingerprint of the state. */
SUNDER_API sunder_status sunder_world_state_hash(const sunder_world* world, uint64_t* hash);

/* What follows is in a library that has its part on the GPU. */

/* Any function of GL; its type is not its own. */
typedef void (*sunder_gl_function)(void);
/* Finds a function of GL, such as glfwGetProcAddress. */
typedef sunder_gl_function (*sunder_get_proc_address)(const char* name);

/* Adopts the context that is current. `dirty`: whether the host's GL state may be left changed.
   Null where it fails. */
SUNDER_API sunder_device* sunder_device_create(sunder_get_proc_address find, int dirty);
/* After its worlds and surfaces. Null does nothing. */
SUNDER_API void sunder_device_destroy(sunder_device* device);
/* `pieces`: whether each vertex knows the number of its piece. Null where it fails. */
SUNDER_API sunder_surface* sunder_surface_create(sunder_device* device, sunder_world* world,
                                                 int pieces);
/* Before its world. Null does nothing. */
SUNDER_API void sunder_surface_destroy(sunder_surface* surface);
/* Deforms the mesh as the world is now. */
SUNDER_API sunder_status sunder_surface_update(sunder_surface* surface);
/* Names of GL, for what sunder::gl::Surface says of them (sunder/gl.hpp). */
SUNDER_API unsigned sunder_surface_vertex_array(const sunder_surface* surface);
/* Likewise: the vertices that sunder_surface_update() writes. */
SUNDER_API unsigned sunder_surface_vertex_buffer(const sunder_surface* surface);
/* Likewise: what of them stays the same. */
SUNDER_API unsigned sunder_surface_rest_buffer(const sunder_surface* surface);
/* Likewise: the numbers of their pieces, or 0. */
SUNDER_API unsigned sunder_surface_piece_buffer(const sunder_surface* surface);
/* Likewise: the indices. */
SUNDER_API unsigned sunder_surface_index_buffer(const sunder_surface* surface);
/* Likewise: a vertex array with what a vertex shader of the host's reads. */
SUNDER_API unsigned sunder_surface_source_array(const sunder_surface* surface);
/* How many vertices there are. */
SUNDER_API int sunder_surface_vertices(const sunder_surface* surface);
/* How many bodies the last update wrote; `*changed` is valid until the next. */
SUNDER_API size_t sunder_surface_changed(sunder_surface* surface,
                                         const sunder_vertex_range** changed);
/* GLSL for a vertex shader of the host's; `*text` is valid until the next call. */
SUNDER_API sunder_status sunder_surface_vertex_shader(sunder_surface* surface, const char** text);
/* What its samplers read as the world is now: five. `textures` has room for them. */
SUNDER_API sunder_status sunder_surface_vertex_textures(sunder_surface* surface,
                                                        sunder_vertex_texture* textures);
/* How many ranges there are; `*ranges` is valid until the next call. */
SUNDER_API size_t sunder_surface_ranges(sunder_surface* surface, const sunder_range** ranges);

#ifdef __cplusplus
}
#endif

#endif
