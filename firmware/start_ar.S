/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Reset of the Cortex-A and Cortex-R boards: vectors, one core, stack, FPU, then C.
 * Caches and memory protection stay off, so the code is built without unaligned access.
 */
    .syntax unified
    .arm

    .section .vectors, "ax"
    .global vectors
vectors:
    ldr pc, =reset
    ldr pc, =fault      /* undefined instruction */
    ldr pc, =fault      /* supervisor call; the debugger takes semihosting before this */
    ldr pc, =fault      /* prefetch abort */
    ldr pc, =fault      /* data abort */
    ldr pc, =fault
    ldr pc, =fault      /* interrupt: none is enabled */
    ldr pc, =fault      /* fast interrupt */
    .ltorg

    .text
    .global reset
    .type reset, %function
reset:
    mrc p15, 0, r0, c0, c0, 5       /* MPIDR: only core 0 goes on */
    ands r0, r0, #3
    bne park
#if __ARM_ARCH_PROFILE == 'A'
    ldr r0, =vectors                /* VBAR */
    mcr p15, 0, r0, c12, c0, 0
#else
    mrc p15, 0, r0, c1, c0, 0       /* SCTLR.V off: vectors at 0, not at 0xffff0000 */
    bic r0, r0, #(1 << 13)
    mcr p15, 0, r0, c1, c0, 0
    isb
#endif
    mrc p15, 0, r0, c1, c0, 2       /* CPACR: full access to coprocessors 10 and 11 */
    orr r0, r0, #(0xf << 20)
    mcr p15, 0, r0, c1, c0, 2
    isb
    mov r0, #(1 << 30)              /* FPEXC.EN */
    vmsr fpexc, r0
    mov r0, #0                      /* FPSCR: round to nearest, subnormals kept, NaN propagated */
    vmsr fpscr, r0
    ldr sp, =image_stack_top
    bl  start_program

    .type fault, %function
fault:
    ldr sp, =image_stack_top        /* each mode has its own stack pointer, and it is not set */
    mov r0, #99                     /* PORT_STATUS_FAULT */
    bl  port_exit
park:
    wfi
    b   park
