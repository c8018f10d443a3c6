/* An instance's situation, the noise generators' memory included: saved, restored, and as bytes. */
#ifndef SNAPSHOT_H
#define SNAPSHOT_H

#include "instance.h"

/* A snapshot is handed out as void *; one that exists already is reused. */
int snapshot_save(Instance *instance, void **snapshot);
int snapshot_restore(Instance *instance, const void *snapshot);
int snapshot_free(Instance *instance, void **snapshot);

/* The bytes carry a mark of the model and a digest, and no pointers: same situation, same bytes. */
int snapshot_size(Instance *instance, const void *snapshot, size_t *size);
int snapshot_serialize(Instance *instance, const void *snapshot, void *bytes, size_t size);
int snapshot_deserialize(Instance *instance, const void *bytes, size_t size, void **snapshot);

#endif
