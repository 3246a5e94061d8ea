/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Which emitted functions make which finger. A hand of other fingers changes this table.
 */
#include "fifth.h"
#include "hand_parts.h"
#include "index.h"
#include "middle.h"
#include "ring.h"
#include "thumb.h"

const hand_finger hand_fingers[HAND_FINGERS] = {
    {4, 8, thumb_tendon_lengths, thumb_coupling_matrix, thumb_joint_torque, 0},
    {4, 8, index_tendon_lengths, index_coupling_matrix, index_joint_torque, index_link_position},
    {4, 8, middle_tendon_lengths, middle_coupling_matrix, middle_joint_torque,
     middle_link_position},
    {3, 6, ring_tendon_lengths, ring_coupling_matrix, ring_joint_torque, ring_link_position},
    {3, 6, fifth_tendon_lengths, fifth_coupling_matrix, fifth_joint_torque, fifth_link_position}};
