// SPDX-License-Identifier: MIT
// Stands for windows.h where there is none: macros of common words, as a program on Windows has them before it includes our
// headers.
#pragma once

#define max(a, b) (((a) > (b)) ? (a) : (b))
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define near
#define far
#define NEAR
#define FAR
#define IN
#define OUT
#define OPTIONAL
#define VOID void
#define CONST const
#define TRUE 1
#define FALSE 0
#define ERROR 0
#define NO_ERROR 0L
#define STRICT 1
#define DELETE 0x00010000L
#define ABSOLUTE 1
#define RELATIVE 2
#define OPAQUE 2
#define TRANSPARENT 1
#define DIFFERENCE 11
#define MM_TEXT 1
#define INFINITE 0xffffffff
#define CALLBACK __stdcall
#define WINAPI __stdcall
#define PASCAL __stdcall
#define pascal __stdcall
#define cdecl
#define interface struct
#define small char
#define hyper __int64
#define boolean unsigned char
#define grp1 0x0430
#define rad1 0x0420
#define environ _environ
#define Yield()
#define MemoryBarrier _mm_mfence
#define GetObject GetObjectW
#define GetMessage GetMessageW
#define GetClassName GetClassNameW
#define GetCurrentTime() GetTickCount()
#define CreateWindow CreateWindowW
#define DrawText DrawTextW
#define FindText FindTextW
#define LoadImage LoadImageW
#define SendMessage SendMessageW
#define UpdateResource UpdateResourceW
