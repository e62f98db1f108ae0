# Start-up of RV32, RV32E and RV64 without a C library: stack, .data, .bss, main; and the call to the semihosting host.
# Registers are those RV32E has. Where everything is loaded into RAM, .data has no image and needs no copy.
# SPDX-License-Identifier: MIT
  .section .start, "ax"
  .globl _start
_start:
  csrr t0, mhartid
  bnez t0, rest
  la sp, stack_top
  la t0, trap
  csrw mtvec, t0
  la t0, data_image
  la t1, data_begin
  la t2, data_end
copy:
  bgeu t1, t2, copied
  lb a0, 0(t0)
  sb a0, 0(t1)
  addi t0, t0, 1
  addi t1, t1, 1
  j copy
copied:
  la t1, bss_begin
  la t2, bss_end
clear:
  bgeu t1, t2, cleared
  sb zero, 0(t1)
  addi t1, t1, 1
  j clear
cleared:
  call main
  j host_exit
rest:
  wfi
  j rest
  .balign 4
trap:
  li a0, 1
  j host_exit

# The host knows its call by three instructions of full length on one page.
  .text
  .globl host_call
  .balign 16
host_call:
  .option push
  .option norvc
  slli zero, zero, 0x1f
  ebreak
  srai zero, zero, 7
  .option pop
  ret
