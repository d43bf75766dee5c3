// SPDX-License-Identifier: Apache-2.0
// The corners of one triangle over the whole picture, 0 to 2 from its lower left: without vertices, for vertices 0 to 2.
vec2 corner_of_whole() { return vec2((gl_VertexID & 1) << 1, gl_VertexID & 2); }
