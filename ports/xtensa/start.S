# Start-up of an lx106 on QEMU's sim machine: stack, .bss, the self-test, and the two calls to the host.
# SPDX-License-Identifier: MIT
  .section .reset, "ax"
  j begin

  .text
  .literal_position
  .align 4
begin:
  movi a1, stack_top
  movi a2, bss_begin
  movi a3, bss_end
  movi a4, 0
clear:
  bgeu a2, a3, cleared
  s8i a4, a2, 0
  addi a2, a2, 1
  j clear
cleared:
  call0 main
  mov a3, a2
  movi a2, 1
  simcall                # exit(a3)
stop:
  j stop

# host_put(character): write(1, its place, 1)
  .literal_position
  .align 4
  .globl host_put
host_put:
  addi a1, a1, -16
  s8i a2, a1, 0
  mov a4, a1
  movi a5, 1
  movi a3, 1
  movi a2, 4
  simcall
  addi a1, a1, 16
  ret
