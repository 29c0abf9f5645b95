; ModuleID = 'follow_blocks'
source_filename = "<string>"
target datalayout = "e-m:e-p270:32:32-p271:32:32-p272:64:64-i64:64-i128:128-f80:128-n8:16:32:64-S128"
target triple = "x86_64-unknown-linux-gnu"

@.const.follow_blocks = internal constant [14 x i8] c"follow_blocks\00"
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks13follow_blocksB2v1B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqEpgoEBZSIkILKIJAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2934ConstantForce_28float64_20x_201_29274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29478BlockElements_28ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20float64_29x5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29vvvv = common local_unnamed_addr global ptr null
@PyExc_RuntimeError = external global i8
@".const.missing Environment: _ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks13follow_blocksB2v1B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqEpgoEBZSIkILKIJAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2934ConstantForce_28float64_20x_201_29274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29478BlockElements_28ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20float64_29x5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29vvvv" = internal constant [1223 x i8] c"missing Environment: _ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks13follow_blocksB2v1B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqEpgoEBZSIkILKIJAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2934ConstantForce_28float64_20x_201_29274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29478BlockElements_28ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20float64_29x5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29vvvv\00"
@PyExc_ValueError = external global i8
@".const.size mismatch for tuple, expected 3 element(s) but got %zd" = internal constant [59 x i8] c"size mismatch for tuple, expected 3 element(s) but got %zd\00"
@PyExc_TypeError = external global i8
@".const.can't unbox array from PyObject into native value.  The object maybe of a different type" = internal constant [89 x i8] c"can't unbox array from PyObject into native value.  The object maybe of a different type\00"
@".const.size mismatch for tuple, expected 1 element(s) but got %zd" = internal constant [59 x i8] c"size mismatch for tuple, expected 1 element(s) but got %zd\00"
@".const.size mismatch for tuple, expected 7 element(s) but got %zd" = internal constant [59 x i8] c"size mismatch for tuple, expected 7 element(s) but got %zd\00"
@".const.size mismatch for tuple, expected 4 element(s) but got %zd" = internal constant [59 x i8] c"size mismatch for tuple, expected 4 element(s) but got %zd\00"
@".const.size mismatch for tuple, expected 6 element(s) but got %zd" = internal constant [59 x i8] c"size mismatch for tuple, expected 6 element(s) but got %zd\00"
@".const.size mismatch for tuple, expected 8 element(s) but got %zd" = internal constant [59 x i8] c"size mismatch for tuple, expected 8 element(s) but got %zd\00"
@.const.pickledata.a3f35a65b9e37846edcc099731c801853500822c = internal constant [78 x i8] c"\80\04\95C\00\00\00\00\00\00\00\8C-elastomer_friction.kernels.scene.march_blocks\94\8C\0DBlockElements\94\93\94."
@.const.pickledata.a3f35a65b9e37846edcc099731c801853500822c.sha1 = internal constant [20 x i8] c"\A3\F3Ze\B9\E3xF\ED\CC\09\971\C8\01\855\00\82,"
@.const.pickledata.1e8642808d94220167a3f7d7bcccdb722eecb5ad = internal constant [78 x i8] c"\80\04\95C\00\00\00\00\00\00\00\8C-elastomer_friction.kernels.scene.march_blocks\94\8C\0DElementBlocks\94\93\94."
@.const.pickledata.1e8642808d94220167a3f7d7bcccdb722eecb5ad.sha1 = internal constant [20 x i8] c"\1E\86B\80\8D\94\22\01g\A3\F7\D7\BC\CC\DBr.\EC\B5\AD"
@".const.`env.consts` is NULL in `read_const`" = internal constant [37 x i8] c"`env.consts` is NULL in `read_const`\00"
@.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3 = internal constant [32 x i8] c"\80\04\95\15\00\00\00\00\00\00\00\8C\05numpy\94\8C\07ndarray\94\93\94."
@.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1 = internal constant [20 x i8] c"\DF\BC\FD\D3\9F\CB&\F4\D0\C6\80\95D\87\B8\C0\B5;\B8\A3"
@.const.pickledata.043d37c924107a8e462ba1f317a63b2e2f59065c = internal constant [68 x i8] c"\80\04\959\00\00\00\00\00\00\00\8C*elastomer_friction.kernels.rheology.scaled\94\8C\06Scales\94\93\94."
@.const.pickledata.043d37c924107a8e462ba1f317a63b2e2f59065c.sha1 = internal constant [20 x i8] c"\04=7\C9$\10z\8EF+\A1\F3\17\A6;./Y\06\\"
@".const.Error creating Python tuple from runtime exception arguments" = internal constant [61 x i8] c"Error creating Python tuple from runtime exception arguments\00"
@PyExc_StopIteration = external global i8
@PyExc_SystemError = external global i8
@".const.unknown error when calling native function" = internal constant [43 x i8] c"unknown error when calling native function\00"
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks15room_for_blocksB2v2B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEx = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v3B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE48omitted_28default_3d_3cclass_20_27float_27_3e_29 = common local_unnamed_addr global ptr null
@.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b = internal constant [77 x i8] c"\80\04\95B\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C\1Fnegative dimensions not allowed\94\85\94N\87\94."
@.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1 = internal constant [20 x i8] c"3\1B\85c\BD\B9\DA\C8\1B8B\22s\05,Ho\C1pk"
@.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b, i32 77, ptr @.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1, ptr null, i32 0 }
@.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57 = internal constant [137 x i8] c"\80\04\95~\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C[array is too big; `arr.size * arr.dtype.itemsize` is larger than the maximum possible size.\94\85\94N\87\94."
@.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1 = internal constant [20 x i8] c"X\E1N\CC\B5\07\B1\E0 i\81t\02#\E6\85\CB\8C<W"
@.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57, i32 137, ptr @.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1, ptr null, i32 0 }
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209 = internal constant [86 x i8] c"\80\04\95K\00\00\00\00\00\00\00\8C\08builtins\94\8C\0BMemoryError\94\93\94\8C'Allocation failed (probably too large).\94\85\94N\87\94."
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1 = internal constant [20 x i8] c"\BA(\9D\81\F0\\p \F3G|\15sH\04\DFe\AB\E2\09"
@.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209, i32 86, ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1, ptr null, i32 0 }
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.8 = internal constant [86 x i8] c"\80\04\95K\00\00\00\00\00\00\00\8C\08builtins\94\8C\0BMemoryError\94\93\94\8C'Allocation failed (probably too large).\94\85\94N\87\94."
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.9 = internal constant [20 x i8] c"\BA(\9D\81\F0\\p \F3G|\15sH\04\DFe\AB\E2\09"
@.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.7 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.8, i32 86, ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.9, ptr null, i32 0 }
@_ZN08NumbaEnv5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v7B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx16class_28int64_29 = common local_unnamed_addr global ptr null
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.19 = internal constant [86 x i8] c"\80\04\95K\00\00\00\00\00\00\00\8C\08builtins\94\8C\0BMemoryError\94\93\94\8C'Allocation failed (probably too large).\94\85\94N\87\94."
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.20 = internal constant [20 x i8] c"\BA(\9D\81\F0\\p \F3G|\15sH\04\DFe\AB\E2\09"
@.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.18 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.19, i32 86, ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.20, ptr null, i32 0 }
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks7_lowestB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj12impl_np_full12_3clocals_3e4fullB2v9B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dExd27omitted_28default_3dNone_29 = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v10B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx18class_28float64_29 = common local_unnamed_addr global ptr null
@.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.11 = internal constant [77 x i8] c"\80\04\95B\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C\1Fnegative dimensions not allowed\94\85\94N\87\94."
@.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1.12 = internal constant [20 x i8] c"3\1B\85c\BD\B9\DA\C8\1B8B\22s\05,Ho\C1pk"
@.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b.10 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.11, i32 77, ptr @.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1.12, ptr null, i32 0 }
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.13 = internal constant [86 x i8] c"\80\04\95K\00\00\00\00\00\00\00\8C\08builtins\94\8C\0BMemoryError\94\93\94\8C'Allocation failed (probably too large).\94\85\94N\87\94."
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.14 = internal constant [20 x i8] c"\BA(\9D\81\F0\\p \F3G|\15sH\04\DFe\AB\E2\09"
@.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.9 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.13, i32 86, ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.14, ptr null, i32 0 }
@_ZN08NumbaEnv18elastomer_friction7kernels5scene6follow11first_afterB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels8rheology5prony7_law_ofB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29d = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29 = common local_unnamed_addr global ptr null
@.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.21 = internal constant [77 x i8] c"\80\04\95B\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C\1Fnegative dimensions not allowed\94\85\94N\87\94."
@.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1.22 = internal constant [20 x i8] c"3\1B\85c\BD\B9\DA\C8\1B8B\22s\05,Ho\C1pk"
@.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b.20 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.21, i32 77, ptr @.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1.22, ptr null, i32 0 }
@.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.4 = internal constant [137 x i8] c"\80\04\95~\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C[array is too big; `arr.size * arr.dtype.itemsize` is larger than the maximum possible size.\94\85\94N\87\94."
@.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1.5 = internal constant [20 x i8] c"X\E1N\CC\B5\07\B1\E0 i\81t\02#\E6\85\CB\8C<W"
@.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57.3 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.4, i32 137, ptr @.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1.5, ptr null, i32 0 }
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.24 = internal constant [86 x i8] c"\80\04\95K\00\00\00\00\00\00\00\8C\08builtins\94\8C\0BMemoryError\94\93\94\8C'Allocation failed (probably too large).\94\85\94N\87\94."
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.25 = internal constant [20 x i8] c"\BA(\9D\81\F0\\p \F3G|\15sH\04\DFe\AB\E2\09"
@.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.19 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.24, i32 86, ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.25, ptr null, i32 0 }
@_ZN08NumbaEnv18elastomer_friction7kernels8rheology5prony7momentsB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np9arraymath9array_sum12_3clocals_3e14array_sum_implB3v25B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE27omitted_28default_3dNone_2927omitted_28default_3dNone_29 = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np9arraymath17check_axis_boundsB3v16B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedEv = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np9arraymath16check_duplicatesB3v17B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEvx = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np9arraymath7npy_max12_3clocals_3e8impl_maxB3v18B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@.const.pickledata.e8300ab22a452ebe34461c60166a3da7fccf8c92 = internal constant [206 x i8] c"\80\04\95\C3\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8CDzero-size array to reduction operation maximum which has no identity\94\85\94\8C\08impl_max\94\8CJ/work/rooms/bench/.venv/lib/python3.11/site-packages/numba/np/arraymath.py\94M?\04\87\94\87\94."
@.const.pickledata.e8300ab22a452ebe34461c60166a3da7fccf8c92.sha1 = internal constant [20 x i8] c"\E80\0A\B2*E.\BE4F\1C`\16j=\A7\FC\CF\8C\92"
@.const.picklebuf.e8300ab22a452ebe34461c60166a3da7fccf8c92 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.e8300ab22a452ebe34461c60166a3da7fccf8c92, i32 206, ptr @.const.pickledata.e8300ab22a452ebe34461c60166a3da7fccf8c92.sha1, ptr null, i32 0 }
@.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c = internal constant [83 x i8] c"\80\04\95H\00\00\00\00\00\00\00\8C\08builtins\94\8C\13NotImplementedError\94\93\94\8C\1Cincompatible shape for array\94\85\94N\87\94."
@.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.sha1 = internal constant [20 x i8] c"\DC;\BA\83,L7X'=\0D\B2K\83V\91\AF?1l"
@.const.picklebuf.dc3bba832c4c3758273d0db24b835691af3f316c = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c, i32 83, ptr @.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.sha1, ptr null, i32 0 }
@_ZN08NumbaEnv5numba2np9arraymath14max_comparatorB3v22B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEdd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv13_3cdynamic_3e33__numba_array_expr_0x7f6351091710B3v26B72c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqEpEUkESQI1_2bmEQRzHSk5AYW0QQAEddd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np7npyimpl15_broadcast_ontoB3v27B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEx8int64_2ax8int64_2a = common local_unnamed_addr global ptr null
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.23 = internal constant [86 x i8] c"\80\04\95K\00\00\00\00\00\00\00\8C\08builtins\94\8C\0BMemoryError\94\93\94\8C'Allocation failed (probably too large).\94\85\94N\87\94."
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.24 = internal constant [20 x i8] c"\BA(\9D\81\F0\\p \F3G|\15sH\04\DFe\AB\E2\09"
@.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.22 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.23, i32 86, ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.24, ptr null, i32 0 }
@_ZN08NumbaEnv5numba7cpython8builtins6ol_min12_3clocals_3e4implB3v11B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIdLi2EE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv13_3cdynamic_3e33__numba_array_expr_0x7f6351091790B3v28B72c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqEpEUkESQI1_2bmEQRzHSk5AYW0QQAEdd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks5_moveB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE54Choice_28int64_2c_20float64_2c_20float64_2c_20int64_29b5TupleI5ArrayIdLi2E1C7mutable7alignedExxEd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels8rheology6scaled10look_aheadB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29 = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks11round_apartB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np9arraymath7npy_min12_3clocals_3e8impl_minB3v34B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@.const.pickledata.917b4fd376f3111025427fa1537059f6520d9ca7 = internal constant [206 x i8] c"\80\04\95\C3\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8CDzero-size array to reduction operation minimum which has no identity\94\85\94\8C\08impl_min\94\8CJ/work/rooms/bench/.venv/lib/python3.11/site-packages/numba/np/arraymath.py\94M\06\04\87\94\87\94."
@.const.pickledata.917b4fd376f3111025427fa1537059f6520d9ca7.sha1 = internal constant [20 x i8] c"\91{O\D3v\F3\11\10%B\7F\A1SpY\F6R\0D\9C\A7"
@.const.picklebuf.917b4fd376f3111025427fa1537059f6520d9ca7 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.917b4fd376f3111025427fa1537059f6520d9ca7, i32 206, ptr @.const.pickledata.917b4fd376f3111025427fa1537059f6520d9ca7.sha1, ptr null, i32 0 }
@_ZN08NumbaEnv5numba2np8arrayobj15make_nditer_cls12_3clocals_3e6NdIter13init_specific12_3clocals_3e11check_shapeB3v23B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE8UniTupleIxLi1EE8UniTupleIxLi1EE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v37B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29 = common local_unnamed_addr global ptr null
@.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.29 = internal constant [83 x i8] c"\80\04\95H\00\00\00\00\00\00\00\8C\08builtins\94\8C\13NotImplementedError\94\93\94\8C\1Cincompatible shape for array\94\85\94N\87\94."
@.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.sha1.30 = internal constant [20 x i8] c"\DC;\BA\83,L7X'=\0D\B2K\83V\91\AF?1l"
@.const.picklebuf.dc3bba832c4c3758273d0db24b835691af3f316c.28 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.29, i32 83, ptr @.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.sha1.30, ptr null, i32 0 }
@_ZN08NumbaEnv5numba2np9arraymath14min_comparatorB3v36B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dEdd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB3v38B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE15StarArgUniTupleIdLi2EE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks13choose_blocksB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIxLi1E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba7cpython8builtins6ol_min12_3clocals_3e4implB3v32B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE15StarArgUniTupleIxLi2EE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks14balance_blocksB3v40B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedExx213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5model7contact17indentation_underB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB3v51B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIdLi2EE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5model7contact15overlap_of_rowsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5model7contact22_lowest_of_spring_rowsB3v53B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29d = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np9arraymath7npy_min12_3clocals_3e8impl_minB3v54B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi2E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@.const.pickledata.917b4fd376f3111025427fa1537059f6520d9ca7.15 = internal constant [206 x i8] c"\80\04\95\C3\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8CDzero-size array to reduction operation minimum which has no identity\94\85\94\8C\08impl_min\94\8CJ/work/rooms/bench/.venv/lib/python3.11/site-packages/numba/np/arraymath.py\94M\06\04\87\94\87\94."
@.const.pickledata.917b4fd376f3111025427fa1537059f6520d9ca7.sha1.16 = internal constant [20 x i8] c"\91{O\D3v\F3\11\10%B\7F\A1SpY\F6R\0D\9C\A7"
@.const.picklebuf.917b4fd376f3111025427fa1537059f6520d9ca7.11 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.917b4fd376f3111025427fa1537059f6520d9ca7.15, i32 206, ptr @.const.pickledata.917b4fd376f3111025427fa1537059f6520d9ca7.sha1.16, ptr null, i32 0 }
@_ZN08NumbaEnv5numba2np8arrayobj15make_nditer_cls12_3clocals_3e6NdIter13init_specific12_3clocals_3e11check_shapeB3v56B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE8UniTupleIxLi2EE8UniTupleIxLi2EE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29 = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.13 = internal constant [83 x i8] c"\80\04\95H\00\00\00\00\00\00\00\8C\08builtins\94\8C\13NotImplementedError\94\93\94\8C\1Cincompatible shape for array\94\85\94N\87\94."
@.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.sha1.14 = internal constant [20 x i8] c"\DC;\BA\83,L7X'=\0D\B2K\83V\91\AF?1l"
@.const.picklebuf.dc3bba832c4c3758273d0db24b835691af3f316c.12 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.13, i32 83, ptr @.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.sha1.14, ptr null, i32 0 }
@_ZN08NumbaEnv5numba2np8arrayobj23normalize_reshape_valueB3v21B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEy5ArrayIxLi1E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np9arraymath14min_comparatorB3v55B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEdd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks12press_blocksB3v57B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels8rheology6scaled5go_onB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29x = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks8_predictB3v41B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_29 = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels8rheology6scaled18settle_and_predictB3v44B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels8rheology6scaled19_settle_and_predictB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels8rheology6scaled8_predictB3v46B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels8rheology6scaled11all_settledB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29 = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks5_keepB3v60B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEx102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29xdd368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29vv = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks5_sumsB3v61B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29x5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.43 = internal constant [83 x i8] c"\80\04\95H\00\00\00\00\00\00\00\8C\08builtins\94\8C\13NotImplementedError\94\93\94\8C\1Cincompatible shape for array\94\85\94N\87\94."
@.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.sha1.44 = internal constant [20 x i8] c"\DC;\BA\83,L7X'=\0D\B2K\83V\91\AF?1l"
@.const.picklebuf.dc3bba832c4c3758273d0db24b835691af3f316c.42 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.43, i32 83, ptr @.const.pickledata.dc3bba832c4c3758273d0db24b835691af3f316c.sha1.44, ptr null, i32 0 }
@_ZN08NumbaEnv18elastomer_friction7kernels5scene6follow7seen_atB3v58B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29xx = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj11ol_np_zeros12_3clocals_3e4implB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE48omitted_28default_3d_3cclass_20_27float_27_3e_29 = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v63B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE39Function_28_3cclass_20_27float_27_3e_29 = common local_unnamed_addr global ptr null
@.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.49 = internal constant [77 x i8] c"\80\04\95B\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C\1Fnegative dimensions not allowed\94\85\94N\87\94."
@.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1.50 = internal constant [20 x i8] c"3\1B\85c\BD\B9\DA\C8\1B8B\22s\05,Ho\C1pk"
@.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b.39 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.49, i32 77, ptr @.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1.50, ptr null, i32 0 }
@.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.47 = internal constant [137 x i8] c"\80\04\95~\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C[array is too big; `arr.size * arr.dtype.itemsize` is larger than the maximum possible size.\94\85\94N\87\94."
@.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1.48 = internal constant [20 x i8] c"X\E1N\CC\B5\07\B1\E0 i\81t\02#\E6\85\CB\8C<W"
@.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57.40 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.47, i32 137, ptr @.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1.48, ptr null, i32 0 }
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.45 = internal constant [86 x i8] c"\80\04\95K\00\00\00\00\00\00\00\8C\08builtins\94\8C\0BMemoryError\94\93\94\8C'Allocation failed (probably too large).\94\85\94N\87\94."
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.46 = internal constant [20 x i8] c"\BA(\9D\81\F0\\p \F3G|\15sH\04\DFe\AB\E2\09"
@.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.41 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.45, i32 86, ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.46, ptr null, i32 0 }
@_ZN08NumbaEnv5numba2np8arrayobj18ol_array_zero_fill12_3clocals_3e4implB3v64B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi2E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj23normalize_reshape_valueB3v66B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEy5ArrayIxLi1E1C7mutable7alignedE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5model8friction7weighedB3v65B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEv5ArrayIdLi1E1C7mutable7alignedEd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene7records11keep_forcesB3v67B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29xd8UniTupleIdLi3EExdd = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene7records11keep_motionB3v68B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29xd274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29x = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks15_count_as_it_isB3v69B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_29x = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj9np_arange12_3clocals_3e4implB3v70B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx27omitted_28default_3dNone_2927omitted_28default_3dNone_2927omitted_28default_3dNone_29 = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba7cpython8builtins6ol_int12_3clocals_3e4implB3v71B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB3v72B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIxLi2EE = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v73B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx16class_28int64_29 = common local_unnamed_addr global ptr null
@.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.55 = internal constant [137 x i8] c"\80\04\95~\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C[array is too big; `arr.size * arr.dtype.itemsize` is larger than the maximum possible size.\94\85\94N\87\94."
@.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1.56 = internal constant [20 x i8] c"X\E1N\CC\B5\07\B1\E0 i\81t\02#\E6\85\CB\8C<W"
@.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57.54 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.55, i32 137, ptr @.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1.56, ptr null, i32 0 }
@_ZN08NumbaEnv5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj = common local_unnamed_addr global ptr null
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.57 = internal constant [86 x i8] c"\80\04\95K\00\00\00\00\00\00\00\8C\08builtins\94\8C\0BMemoryError\94\93\94\8C'Allocation failed (probably too large).\94\85\94N\87\94."
@.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.58 = internal constant [20 x i8] c"\BA(\9D\81\F0\\p \F3G|\15sH\04\DFe\AB\E2\09"
@.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.53 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.57, i32 86, ptr @.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1.58, ptr null, i32 0 }
@_ZN08NumbaEnv18elastomer_friction7kernels8rheology6scaled8catch_upB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx = common local_unnamed_addr global ptr null
@_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB3v43B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE15StarArgUniTupleIxLi2EE = common local_unnamed_addr global ptr null

define range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels5scene12march_blocks13follow_blocksB2v1B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqEpgoEBZSIkILKIJAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2934ConstantForce_28float64_20x_201_29274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29478BlockElements_28ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20float64_29x5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29vvvv(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, double %arg.form.0, ptr %arg.form.1.0, ptr readnone captures(none) %arg.form.1.1, i64 %arg.form.1.2, i64 %arg.form.1.3, ptr readonly captures(none) %arg.form.1.4, i64 %arg.form.1.5.0, i64 %arg.form.1.6.0, ptr %arg.form.2.0, ptr readnone captures(none) %arg.form.2.1, i64 %arg.form.2.2, i64 %arg.form.2.3, ptr readonly captures(none) %arg.form.2.4, i64 %arg.form.2.5.0, i64 %arg.form.2.6.0, double %arg.control.0, ptr %arg.track.0.0, ptr readnone captures(none) %arg.track.0.1, i64 %arg.track.0.2, i64 %arg.track.0.3, ptr readonly captures(none) %arg.track.0.4, i64 %arg.track.0.5.0, i64 %arg.track.0.5.1, i64 %arg.track.0.6.0, i64 %arg.track.0.6.1, ptr %arg.track.1.0, ptr readnone captures(none) %arg.track.1.1, i64 %arg.track.1.2, i64 %arg.track.1.3, ptr readonly captures(none) %arg.track.1.4, i64 %arg.track.1.5.0, i64 %arg.track.1.5.1, i64 %arg.track.1.6.0, i64 %arg.track.1.6.1, ptr %arg.track.2.0, ptr readnone captures(none) %arg.track.2.1, i64 %arg.track.2.2, i64 %arg.track.2.3, ptr readonly captures(none) %arg.track.2.4, i64 %arg.track.2.5.0, i64 %arg.track.2.6.0, ptr %arg.track.3.0, ptr readnone captures(none) %arg.track.3.1, i64 %arg.track.3.2, i64 %arg.track.3.3, ptr readonly captures(none) %arg.track.3.4, i64 %arg.track.3.5.0, i64 %arg.track.3.6.0, ptr %arg.track.4.0, ptr readnone captures(none) %arg.track.4.1, i64 %arg.track.4.2, i64 %arg.track.4.3, ptr readonly captures(none) %arg.track.4.4, i64 %arg.track.4.5.0, i64 %arg.track.4.6.0, ptr %arg.track.5.0, ptr readnone captures(none) %arg.track.5.1, i64 %arg.track.5.2, i64 %arg.track.5.3, ptr readonly captures(none) %arg.track.5.4, i64 %arg.track.5.5.0, i64 %arg.track.5.6.0, ptr %arg.track.6.0, ptr readnone captures(none) %arg.track.6.1, i64 %arg.track.6.2, i64 %arg.track.6.3, ptr readonly captures(none) %arg.track.6.4, i64 %arg.track.6.5.0, i64 %arg.track.6.6.0, ptr %arg.state.0.0.0, ptr %arg.state.0.0.1, i64 %arg.state.0.0.2, i64 %arg.state.0.0.3, ptr %arg.state.0.0.4, i64 %arg.state.0.0.5.0, i64 %arg.state.0.0.5.1, i64 %arg.state.0.0.5.2, i64 %arg.state.0.0.6.0, i64 %arg.state.0.0.6.1, i64 %arg.state.0.0.6.2, ptr %arg.state.0.1.0, ptr %arg.state.0.1.1, i64 %arg.state.0.1.2, i64 %arg.state.0.1.3, ptr %arg.state.0.1.4, i64 %arg.state.0.1.5.0, i64 %arg.state.0.1.6.0, ptr %arg.state.0.2.0, ptr %arg.state.0.2.1, i64 %arg.state.0.2.2, i64 %arg.state.0.2.3, ptr %arg.state.0.2.4, i64 %arg.state.0.2.5.0, i64 %arg.state.0.2.6.0, ptr %arg.state.0.3.0.0, ptr %arg.state.0.3.0.1, i64 %arg.state.0.3.0.2, i64 %arg.state.0.3.0.3, ptr %arg.state.0.3.0.4, i64 %arg.state.0.3.0.5.0, i64 %arg.state.0.3.0.6.0, ptr %arg.state.0.3.1.0, ptr %arg.state.0.3.1.1, i64 %arg.state.0.3.1.2, i64 %arg.state.0.3.1.3, ptr %arg.state.0.3.1.4, i64 %arg.state.0.3.1.5.0, i64 %arg.state.0.3.1.6.0, ptr %arg.state.0.3.2.0, ptr %arg.state.0.3.2.1, i64 %arg.state.0.3.2.2, i64 %arg.state.0.3.2.3, ptr %arg.state.0.3.2.4, i64 %arg.state.0.3.2.5.0, i64 %arg.state.0.3.2.6.0, ptr %arg.state.0.3.3.0, ptr %arg.state.0.3.3.1, i64 %arg.state.0.3.3.2, i64 %arg.state.0.3.3.3, ptr %arg.state.0.3.3.4, i64 %arg.state.0.3.3.5.0, i64 %arg.state.0.3.3.6.0, ptr %arg.state.0.3.4.0, ptr %arg.state.0.3.4.1, i64 %arg.state.0.3.4.2, i64 %arg.state.0.3.4.3, ptr %arg.state.0.3.4.4, i64 %arg.state.0.3.4.5.0, i64 %arg.state.0.3.4.6.0, ptr %arg.state.0.3.5.0, ptr %arg.state.0.3.5.1, i64 %arg.state.0.3.5.2, i64 %arg.state.0.3.5.3, ptr %arg.state.0.3.5.4, i64 %arg.state.0.3.5.5.0, i64 %arg.state.0.3.5.6.0, ptr %arg.state.1.0, ptr %arg.state.1.1, i64 %arg.state.1.2, i64 %arg.state.1.3, ptr %arg.state.1.4, i64 %arg.state.1.5.0, i64 %arg.state.1.5.1, i64 %arg.state.1.6.0, i64 %arg.state.1.6.1, ptr %arg.state.2.0, ptr %arg.state.2.1, i64 %arg.state.2.2, i64 %arg.state.2.3, ptr %arg.state.2.4, i64 %arg.state.2.5.0, i64 %arg.state.2.5.1, i64 %arg.state.2.6.0, i64 %arg.state.2.6.1, double %arg.state.3, i64 %arg.done, ptr %arg.ends.0, ptr readnone captures(none) %arg.ends.1, i64 %arg.ends.2, i64 %arg.ends.3, ptr readonly captures(none) %arg.ends.4, i64 %arg.ends.5.0, i64 %arg.ends.6.0, ptr %arg.kept.0, ptr readnone captures(none) %arg.kept.1, i64 %arg.kept.2, i64 %arg.kept.3, ptr readonly captures(none) %arg.kept.4, i64 %arg.kept.5.0, i64 %arg.kept.6.0, ptr %arg.frames.0, ptr readnone captures(none) %arg.frames.1, i64 %arg.frames.2, i64 %arg.frames.3, ptr readonly captures(none) %arg.frames.4, i64 %arg.frames.5.0, i64 %arg.frames.6.0, ptr %arg.trace.0.0, ptr readnone captures(none) %arg.trace.0.1, i64 %arg.trace.0.2, i64 %arg.trace.0.3, ptr writeonly captures(none) %arg.trace.0.4, i64 %arg.trace.0.5.0, i64 %arg.trace.0.6.0, ptr %arg.trace.1.0, ptr readnone captures(none) %arg.trace.1.1, i64 %arg.trace.1.2, i64 %arg.trace.1.3, ptr writeonly captures(none) %arg.trace.1.4, i64 %arg.trace.1.5.0, i64 %arg.trace.1.6.0, ptr %arg.trace.2.0, ptr readnone captures(none) %arg.trace.2.1, i64 %arg.trace.2.2, i64 %arg.trace.2.3, ptr writeonly captures(none) %arg.trace.2.4, i64 %arg.trace.2.5.0, i64 %arg.trace.2.6.0, ptr %arg.trace.3.0, ptr readnone captures(none) %arg.trace.3.1, i64 %arg.trace.3.2, i64 %arg.trace.3.3, ptr writeonly captures(none) %arg.trace.3.4, i64 %arg.trace.3.5.0, i64 %arg.trace.3.6.0, ptr %arg.trace.4.0, ptr readnone captures(none) %arg.trace.4.1, i64 %arg.trace.4.2, i64 %arg.trace.4.3, ptr writeonly captures(none) %arg.trace.4.4, i64 %arg.trace.4.5.0, i64 %arg.trace.4.6.0, ptr %arg.trace.5.0, ptr readnone captures(none) %arg.trace.5.1, i64 %arg.trace.5.2, i64 %arg.trace.5.3, ptr writeonly captures(none) %arg.trace.5.4, i64 %arg.trace.5.5.0, i64 %arg.trace.5.6.0, ptr %arg.trace.6.0, ptr readnone captures(none) %arg.trace.6.1, i64 %arg.trace.6.2, i64 %arg.trace.6.3, ptr writeonly captures(none) %arg.trace.6.4, i64 %arg.trace.6.5.0, i64 %arg.trace.6.6.0, ptr %arg.trace.7.0, ptr readnone captures(none) %arg.trace.7.1, i64 %arg.trace.7.2, i64 %arg.trace.7.3, ptr writeonly captures(none) %arg.trace.7.4, i64 %arg.trace.7.5.0, i64 %arg.trace.7.6.0, ptr readnone captures(none) %arg.ledger, ptr readnone captures(none) %arg.lengths, ptr readnone captures(none) %arg.film, ptr readnone captures(none) %arg.spell) local_unnamed_addr {
B0.else.if:
  %.860 = alloca { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.0.1.gep1152 = getelementptr inbounds nuw i8, ptr %.860, i64 8
  %.fca.0.2.gep1153 = getelementptr inbounds nuw i8, ptr %.860, i64 16
  %.fca.0.3.gep1154 = getelementptr inbounds nuw i8, ptr %.860, i64 24
  %.fca.0.4.gep1155 = getelementptr inbounds nuw i8, ptr %.860, i64 32
  %.fca.0.5.0.gep1156 = getelementptr inbounds nuw i8, ptr %.860, i64 40
  %.fca.0.6.0.gep1157 = getelementptr inbounds nuw i8, ptr %.860, i64 48
  %.fca.1.0.0.gep = getelementptr inbounds nuw i8, ptr %.860, i64 56
  %.fca.1.0.1.gep = getelementptr inbounds nuw i8, ptr %.860, i64 64
  %.fca.1.0.2.gep = getelementptr inbounds nuw i8, ptr %.860, i64 72
  %.fca.1.0.3.gep = getelementptr inbounds nuw i8, ptr %.860, i64 80
  %.fca.1.0.4.gep = getelementptr inbounds nuw i8, ptr %.860, i64 88
  %.fca.1.0.5.0.gep = getelementptr inbounds nuw i8, ptr %.860, i64 96
  %.fca.1.0.5.1.gep = getelementptr inbounds nuw i8, ptr %.860, i64 104
  %.fca.1.0.6.0.gep = getelementptr inbounds nuw i8, ptr %.860, i64 112
  %.fca.1.0.6.1.gep = getelementptr inbounds nuw i8, ptr %.860, i64 120
  %.fca.1.1.0.gep = getelementptr inbounds nuw i8, ptr %.860, i64 128
  %.fca.1.1.1.gep = getelementptr inbounds nuw i8, ptr %.860, i64 136
  %.fca.1.1.2.gep = getelementptr inbounds nuw i8, ptr %.860, i64 144
  %.fca.1.1.3.gep = getelementptr inbounds nuw i8, ptr %.860, i64 152
  %.fca.1.1.4.gep = getelementptr inbounds nuw i8, ptr %.860, i64 160
  %.fca.1.1.5.0.gep = getelementptr inbounds nuw i8, ptr %.860, i64 168
  %.fca.1.1.6.0.gep = getelementptr inbounds nuw i8, ptr %.860, i64 176
  %.fca.1.2.0.gep = getelementptr inbounds nuw i8, ptr %.860, i64 184
  %.fca.1.2.1.gep = getelementptr inbounds nuw i8, ptr %.860, i64 192
  %.fca.1.2.2.gep = getelementptr inbounds nuw i8, ptr %.860, i64 200
  %.fca.1.2.3.gep = getelementptr inbounds nuw i8, ptr %.860, i64 208
  %.fca.1.2.4.gep = getelementptr inbounds nuw i8, ptr %.860, i64 216
  %.fca.1.2.5.0.gep = getelementptr inbounds nuw i8, ptr %.860, i64 224
  %.fca.1.2.6.0.gep = getelementptr inbounds nuw i8, ptr %.860, i64 232
  %.fca.2.0.gep1158 = getelementptr inbounds nuw i8, ptr %.860, i64 240
  %.fca.2.1.gep1159 = getelementptr inbounds nuw i8, ptr %.860, i64 248
  %.fca.2.2.gep1160 = getelementptr inbounds nuw i8, ptr %.860, i64 256
  %.fca.2.3.gep1161 = getelementptr inbounds nuw i8, ptr %.860, i64 264
  %.fca.2.4.gep1162 = getelementptr inbounds nuw i8, ptr %.860, i64 272
  %.fca.2.5.0.gep1163 = getelementptr inbounds nuw i8, ptr %.860, i64 280
  %.fca.2.6.0.gep1164 = getelementptr inbounds nuw i8, ptr %.860, i64 288
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.985 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  %excinfo.2 = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.985, i8 0, i64 56, i1 false)
  store ptr null, ptr %excinfo.2, align 8
  %.1181 = alloca { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, double }, align 8
  %excinfo.6 = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(192) %.1181, i8 0, i64 192, i1 false)
  store ptr null, ptr %excinfo.6, align 8
  %.1601 = alloca { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, double }, align 8
  %excinfo.7 = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(192) %.1601, i8 0, i64 192, i1 false)
  store ptr null, ptr %excinfo.7, align 8
  %.1820 = alloca { double, i64, { i64, double, double, i64 } }, align 8
  %excinfo.8 = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(48) %.1820, i8 0, i64 48, i1 false)
  store ptr null, ptr %excinfo.8, align 8
  %.2281 = alloca ptr, align 8
  store ptr null, ptr %.2281, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.2471 = alloca ptr, align 8
  store ptr null, ptr %.2471, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.2577 = alloca ptr, align 8
  store ptr null, ptr %.2577, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.2719 = alloca ptr, align 8
  store ptr null, ptr %.2719, align 8
  %excinfo.13 = alloca ptr, align 8
  store ptr null, ptr %excinfo.13, align 8
  %.3388 = alloca ptr, align 8
  store ptr null, ptr %.3388, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  tail call void @NRT_incref(ptr %arg.form.1.0)
  tail call void @NRT_incref(ptr %arg.form.2.0)
  tail call void @NRT_incref(ptr %arg.track.0.0)
  tail call void @NRT_incref(ptr %arg.track.1.0)
  tail call void @NRT_incref(ptr %arg.track.2.0)
  tail call void @NRT_incref(ptr %arg.track.3.0)
  tail call void @NRT_incref(ptr %arg.track.4.0)
  tail call void @NRT_incref(ptr %arg.track.5.0)
  tail call void @NRT_incref(ptr %arg.track.6.0)
  tail call void @NRT_incref(ptr %arg.state.0.0.0)
  tail call void @NRT_incref(ptr %arg.state.0.1.0)
  tail call void @NRT_incref(ptr %arg.state.0.2.0)
  tail call void @NRT_incref(ptr %arg.state.0.3.0.0)
  tail call void @NRT_incref(ptr %arg.state.0.3.1.0)
  tail call void @NRT_incref(ptr %arg.state.0.3.2.0)
  tail call void @NRT_incref(ptr %arg.state.0.3.3.0)
  tail call void @NRT_incref(ptr %arg.state.0.3.4.0)
  tail call void @NRT_incref(ptr %arg.state.0.3.5.0)
  tail call void @NRT_incref(ptr %arg.state.1.0)
  tail call void @NRT_incref(ptr %arg.state.2.0)
  tail call void @NRT_incref(ptr %arg.ends.0)
  tail call void @NRT_incref(ptr %arg.kept.0)
  tail call void @NRT_incref(ptr %arg.frames.0)
  tail call void @NRT_incref(ptr %arg.trace.0.0)
  tail call void @NRT_incref(ptr %arg.trace.1.0)
  tail call void @NRT_incref(ptr %arg.trace.2.0)
  tail call void @NRT_incref(ptr %arg.trace.3.0)
  tail call void @NRT_incref(ptr %arg.trace.4.0)
  tail call void @NRT_incref(ptr %arg.trace.5.0)
  tail call void @NRT_incref(ptr %arg.trace.6.0)
  tail call void @NRT_incref(ptr %arg.trace.7.0)
  %.812.1 = ashr i64 %arg.track.0.5.1, 1
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(296) %.860, i8 0, i64 296, i1 false)
  %.864 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks15room_for_blocksB2v2B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEx(ptr nonnull %.860, ptr nonnull %excinfo.1, i64 %arg.state.0.1.2)
  %.874.fca.0.0.load = load ptr, ptr %.860, align 8
  %.874.fca.0.1.load = load ptr, ptr %.fca.0.1.gep1152, align 8
  %.874.fca.0.2.load = load i64, ptr %.fca.0.2.gep1153, align 8
  %.874.fca.0.3.load = load i64, ptr %.fca.0.3.gep1154, align 8
  %.874.fca.0.4.load = load ptr, ptr %.fca.0.4.gep1155, align 8
  %.874.fca.0.5.0.load = load i64, ptr %.fca.0.5.0.gep1156, align 8
  %.874.fca.0.6.0.load = load i64, ptr %.fca.0.6.0.gep1157, align 8
  %.874.fca.1.0.0.load = load ptr, ptr %.fca.1.0.0.gep, align 8
  %.874.fca.1.0.1.load = load ptr, ptr %.fca.1.0.1.gep, align 8
  %.874.fca.1.0.2.load = load i64, ptr %.fca.1.0.2.gep, align 8
  %.874.fca.1.0.3.load = load i64, ptr %.fca.1.0.3.gep, align 8
  %.874.fca.1.0.4.load = load ptr, ptr %.fca.1.0.4.gep, align 8
  %.874.fca.1.0.5.0.load = load i64, ptr %.fca.1.0.5.0.gep, align 8
  %.874.fca.1.0.5.1.load = load i64, ptr %.fca.1.0.5.1.gep, align 8
  %.874.fca.1.0.6.0.load = load i64, ptr %.fca.1.0.6.0.gep, align 8
  %.874.fca.1.0.6.1.load = load i64, ptr %.fca.1.0.6.1.gep, align 8
  %.874.fca.1.1.0.load = load ptr, ptr %.fca.1.1.0.gep, align 8
  %.874.fca.1.1.1.load = load ptr, ptr %.fca.1.1.1.gep, align 8
  %.874.fca.1.1.2.load = load i64, ptr %.fca.1.1.2.gep, align 8
  %.874.fca.1.1.3.load = load i64, ptr %.fca.1.1.3.gep, align 8
  %.874.fca.1.1.4.load = load ptr, ptr %.fca.1.1.4.gep, align 8
  %.874.fca.1.1.5.0.load = load i64, ptr %.fca.1.1.5.0.gep, align 8
  %.874.fca.1.1.6.0.load = load i64, ptr %.fca.1.1.6.0.gep, align 8
  %.874.fca.1.2.0.load = load ptr, ptr %.fca.1.2.0.gep, align 8
  %.874.fca.1.2.1.load = load ptr, ptr %.fca.1.2.1.gep, align 8
  %.874.fca.1.2.2.load = load i64, ptr %.fca.1.2.2.gep, align 8
  %.874.fca.1.2.3.load = load i64, ptr %.fca.1.2.3.gep, align 8
  %.874.fca.1.2.4.load = load ptr, ptr %.fca.1.2.4.gep, align 8
  %.874.fca.1.2.5.0.load = load i64, ptr %.fca.1.2.5.0.gep, align 8
  %.874.fca.1.2.6.0.load = load i64, ptr %.fca.1.2.6.0.gep, align 8
  %.874.fca.2.0.load = load ptr, ptr %.fca.2.0.gep1158, align 8
  %.874.fca.2.1.load = load ptr, ptr %.fca.2.1.gep1159, align 8
  %.874.fca.2.2.load = load i64, ptr %.fca.2.2.gep1160, align 8
  %.874.fca.2.3.load = load i64, ptr %.fca.2.3.gep1161, align 8
  %.874.fca.2.4.load = load ptr, ptr %.fca.2.4.gep1162, align 8
  %.874.fca.2.5.0.load = load i64, ptr %.fca.2.5.0.gep1163, align 8
  %.874.fca.2.6.0.load = load i64, ptr %.fca.2.6.0.gep1164, align 8
  %cond = icmp eq i32 %.864, 0
  %scevgep1865 = getelementptr i8, ptr %arg.track.3.4, i64 8
  %scevgep1866 = getelementptr i8, ptr %scevgep1865, i64 -8
  %scevgep1867 = getelementptr i8, ptr %arg.track.2.4, i64 8
  %scevgep1868 = getelementptr i8, ptr %scevgep1867, i64 -8
  br i1 %cond, label %B0.endif.endif, label %B0.endif.if.if, !prof !0

B414:                                             ; preds = %B414.lr.ph, %B1460
  %.1315.0 = phi i64 [ 0, %B414.lr.ph ], [ %.1385, %B1460 ]
  %law.3.sroa.0.03152 = phi ptr [ %.1199.fca.0.0.load, %B414.lr.ph ], [ %law.2.sroa.0.1, %B1460 ]
  %law.3.sroa.14.03151 = phi ptr [ %.1199.fca.0.1.load, %B414.lr.ph ], [ %law.2.sroa.14.1, %B1460 ]
  %law.3.sroa.28.03150 = phi i64 [ %.1199.fca.0.2.load, %B414.lr.ph ], [ %law.2.sroa.28.1, %B1460 ]
  %law.3.sroa.42.03149 = phi i64 [ %.1199.fca.0.3.load, %B414.lr.ph ], [ %law.2.sroa.42.1, %B1460 ]
  %law.3.sroa.56.03148 = phi ptr [ %.1199.fca.0.4.load, %B414.lr.ph ], [ %law.2.sroa.56.1, %B1460 ]
  %law.3.sroa.70.03147 = phi i64 [ %.1199.fca.0.5.0.load, %B414.lr.ph ], [ %law.2.sroa.70.1, %B1460 ]
  %law.3.sroa.84.03146 = phi i64 [ %.1199.fca.0.6.0.load, %B414.lr.ph ], [ %law.2.sroa.84.1, %B1460 ]
  %law.3.sroa.98.03145 = phi ptr [ %.1199.fca.1.0.load, %B414.lr.ph ], [ %law.2.sroa.98.1, %B1460 ]
  %law.3.sroa.112.03144 = phi ptr [ %.1199.fca.1.1.load, %B414.lr.ph ], [ %law.2.sroa.112.1, %B1460 ]
  %law.3.sroa.126.03143 = phi i64 [ %.1199.fca.1.2.load, %B414.lr.ph ], [ %law.2.sroa.126.1, %B1460 ]
  %law.3.sroa.140.03142 = phi i64 [ %.1199.fca.1.3.load, %B414.lr.ph ], [ %law.2.sroa.140.1, %B1460 ]
  %law.3.sroa.154.03141 = phi ptr [ %.1199.fca.1.4.load, %B414.lr.ph ], [ %law.2.sroa.154.1, %B1460 ]
  %law.3.sroa.168.03140 = phi i64 [ %.1199.fca.1.5.0.load, %B414.lr.ph ], [ %law.2.sroa.168.1, %B1460 ]
  %law.3.sroa.182.03139 = phi i64 [ %.1199.fca.1.6.0.load, %B414.lr.ph ], [ %law.2.sroa.182.1, %B1460 ]
  %law.3.sroa.196.03138 = phi ptr [ %.1199.fca.2.0.load, %B414.lr.ph ], [ %law.2.sroa.196.1, %B1460 ]
  %law.3.sroa.210.03137 = phi ptr [ %.1199.fca.2.1.load, %B414.lr.ph ], [ %law.2.sroa.210.1, %B1460 ]
  %law.3.sroa.224.03136 = phi i64 [ %.1199.fca.2.2.load, %B414.lr.ph ], [ %law.2.sroa.224.1, %B1460 ]
  %law.3.sroa.238.03135 = phi i64 [ %.1199.fca.2.3.load, %B414.lr.ph ], [ %law.2.sroa.238.1, %B1460 ]
  %law.3.sroa.252.03134 = phi ptr [ %.1199.fca.2.4.load, %B414.lr.ph ], [ %law.2.sroa.252.1, %B1460 ]
  %law.3.sroa.266.03133 = phi i64 [ %.1199.fca.2.5.0.load, %B414.lr.ph ], [ %law.2.sroa.266.1, %B1460 ]
  %law.3.sroa.280.03132 = phi i64 [ %.1199.fca.2.6.0.load, %B414.lr.ph ], [ %law.2.sroa.280.1, %B1460 ]
  %law.3.sroa.294.03131 = phi double [ %.1199.fca.3.load, %B414.lr.ph ], [ %law.2.sroa.294.1, %B1460 ]
  %law.3.sroa.308.03130 = phi double [ %.1199.fca.4.load, %B414.lr.ph ], [ %law.2.sroa.308.1, %B1460 ]
  %law.3.sroa.322.03129 = phi double [ %.1199.fca.5.load, %B414.lr.ph ], [ %law.2.sroa.322.1, %B1460 ]
  %k.2.03128 = phi i64 [ %k.3.0.i, %B414.lr.ph ], [ %k.3.1, %B1460 ]
  %end.2.03126 = phi i64 [ %k.3.0.i320, %B414.lr.ph ], [ %end.3.1, %B1460 ]
  %choice.2.sroa.0.03125 = phi i64 [ -1, %B414.lr.ph ], [ %.1890.fca.2.0.load, %B1460 ]
  %choice.2.sroa.11.03124 = phi double [ 0x7FF0000000000000, %B414.lr.ph ], [ %.1890.fca.2.1.load, %B1460 ]
  %choice.2.sroa.22.03123 = phi double [ %arg.state.3, %B414.lr.ph ], [ %.1890.fca.2.2.load, %B1460 ]
  %choice.2.sroa.33.03122 = phi i64 [ 0, %B414.lr.ph ], [ %.1890.fca.2.3.load, %B1460 ]
  %passes.2.03121 = phi i64 [ 0, %B414.lr.ph ], [ %.1924, %B1460 ]
  %d.2.03120 = phi double [ %arg.state.3, %B414.lr.ph ], [ %.1890.fca.0.load, %B1460 ]
  %older.2.sroa.0.03119 = phi ptr [ %arg.state.2.0, %B414.lr.ph ], [ %p.2.sroa.0.03110, %B1460 ]
  %older.2.sroa.13.03118 = phi ptr [ %arg.state.2.1, %B414.lr.ph ], [ %p.2.sroa.13.03109, %B1460 ]
  %older.2.sroa.26.03117 = phi i64 [ %arg.state.2.2, %B414.lr.ph ], [ %p.2.sroa.26.03108, %B1460 ]
  %older.2.sroa.39.03116 = phi i64 [ %arg.state.2.3, %B414.lr.ph ], [ %p.2.sroa.39.03107, %B1460 ]
  %older.2.sroa.52.03115 = phi ptr [ %arg.state.2.4, %B414.lr.ph ], [ %p.2.sroa.52.03106, %B1460 ]
  %older.2.sroa.65.03114 = phi i64 [ %arg.state.2.5.0, %B414.lr.ph ], [ %p.2.sroa.65.03105, %B1460 ]
  %older.2.sroa.78.03113 = phi i64 [ %arg.state.2.5.1, %B414.lr.ph ], [ %p.2.sroa.78.03104, %B1460 ]
  %older.2.sroa.91.03112 = phi i64 [ %arg.state.2.6.0, %B414.lr.ph ], [ %p.2.sroa.91.03103, %B1460 ]
  %older.2.sroa.104.03111 = phi i64 [ %arg.state.2.6.1, %B414.lr.ph ], [ %p.2.sroa.104.03102, %B1460 ]
  %p.2.sroa.0.03110 = phi ptr [ %arg.state.1.0, %B414.lr.ph ], [ %older.2.sroa.0.03119, %B1460 ]
  %p.2.sroa.13.03109 = phi ptr [ %arg.state.1.1, %B414.lr.ph ], [ %older.2.sroa.13.03118, %B1460 ]
  %p.2.sroa.26.03108 = phi i64 [ %arg.state.1.2, %B414.lr.ph ], [ %older.2.sroa.26.03117, %B1460 ]
  %p.2.sroa.39.03107 = phi i64 [ %arg.state.1.3, %B414.lr.ph ], [ %older.2.sroa.39.03116, %B1460 ]
  %p.2.sroa.52.03106 = phi ptr [ %arg.state.1.4, %B414.lr.ph ], [ %older.2.sroa.52.03115, %B1460 ]
  %p.2.sroa.65.03105 = phi i64 [ %arg.state.1.5.0, %B414.lr.ph ], [ %older.2.sroa.65.03114, %B1460 ]
  %p.2.sroa.78.03104 = phi i64 [ %arg.state.1.5.1, %B414.lr.ph ], [ %older.2.sroa.78.03113, %B1460 ]
  %p.2.sroa.91.03103 = phi i64 [ %arg.state.1.6.0, %B414.lr.ph ], [ %older.2.sroa.91.03112, %B1460 ]
  %p.2.sroa.104.03102 = phi i64 [ %arg.state.1.6.1, %B414.lr.ph ], [ %older.2.sroa.104.03111, %B1460 ]
  %.1385 = add nuw i64 %.1315.0, 1
  %0 = add i64 %.1315.0, 1
  tail call void @NRT_incref(ptr %law.3.sroa.0.03152)
  tail call void @NRT_incref(ptr %law.3.sroa.98.03145)
  tail call void @NRT_incref(ptr %law.3.sroa.196.03138)
  %.1438 = add i64 %.1437, %.1315.0
  %.1449 = icmp sgt i64 %.1315.0, 0
  br i1 %.1449, label %B448, label %B564

B448:                                             ; preds = %B414
  %1 = shl i64 %.1315.0, 3
  %scevgep = getelementptr i8, ptr %arg.track.4.4, i64 %1
  %.1517 = load double, ptr %scevgep, align 8
  %scevgep1854 = getelementptr i8, ptr %scevgep, i64 -8
  %.1556 = load double, ptr %scevgep1854, align 8
  %.1560 = fcmp une double %.1517, %.1556
  tail call void @NRT_decref(ptr %law.3.sroa.0.03152)
  tail call void @NRT_decref(ptr %law.3.sroa.98.03145)
  tail call void @NRT_decref(ptr %law.3.sroa.196.03138)
  br i1 %.1560, label %B510, label %B564

B510:                                             ; preds = %B448
  %sunkaddr = mul i64 %.1315.0, 8
  %sunkaddr1873 = getelementptr i8, ptr %arg.track.4.4, i64 %sunkaddr
  %.1596 = load double, ptr %sunkaddr1873, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(192) %.1601, i8 0, i64 192, i1 false)
  %.1609 = call i32 @_ZN18elastomer_friction7kernels8rheology5prony7_law_ofB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29d(ptr nonnull %.1601, ptr nonnull %excinfo.7, double %arg.form.0, ptr %arg.form.1.0, ptr %arg.form.1.1, i64 %arg.form.1.2, i64 %arg.form.1.3, ptr %arg.form.1.4, i64 %arg.form.1.5.0, i64 %arg.form.1.6.0, ptr %arg.form.2.0, ptr %arg.form.2.1, i64 %arg.form.2.2, i64 %arg.form.2.3, ptr %arg.form.2.4, i64 %arg.form.2.5.0, i64 %arg.form.2.6.0, double %.1596)
  %cond343 = icmp eq i32 %.1609, 0
  br i1 %cond343, label %B510.endif, label %B510.if.if, !prof !0

B564:                                             ; preds = %B510.endif, %B448, %B414
  %law.3.sroa.196.1 = phi ptr [ null, %B510.endif ], [ null, %B448 ], [ %law.3.sroa.196.03138, %B414 ]
  %law.3.sroa.98.1 = phi ptr [ null, %B510.endif ], [ null, %B448 ], [ %law.3.sroa.98.03145, %B414 ]
  %law.3.sroa.0.1 = phi ptr [ null, %B510.endif ], [ null, %B448 ], [ %law.3.sroa.0.03152, %B414 ]
  %law.2.sroa.322.1 = phi double [ %.1619.fca.5.load, %B510.endif ], [ %law.3.sroa.322.03129, %B448 ], [ %law.3.sroa.322.03129, %B414 ]
  %law.2.sroa.308.1 = phi double [ %.1619.fca.4.load, %B510.endif ], [ %law.3.sroa.308.03130, %B448 ], [ %law.3.sroa.308.03130, %B414 ]
  %law.2.sroa.294.1 = phi double [ %.1619.fca.3.load, %B510.endif ], [ %law.3.sroa.294.03131, %B448 ], [ %law.3.sroa.294.03131, %B414 ]
  %law.2.sroa.280.1 = phi i64 [ %.1619.fca.2.6.0.load, %B510.endif ], [ %law.3.sroa.280.03132, %B448 ], [ %law.3.sroa.280.03132, %B414 ]
  %law.2.sroa.266.1 = phi i64 [ %.1619.fca.2.5.0.load, %B510.endif ], [ %law.3.sroa.266.03133, %B448 ], [ %law.3.sroa.266.03133, %B414 ]
  %law.2.sroa.252.1 = phi ptr [ %.1619.fca.2.4.load, %B510.endif ], [ %law.3.sroa.252.03134, %B448 ], [ %law.3.sroa.252.03134, %B414 ]
  %law.2.sroa.238.1 = phi i64 [ %.1619.fca.2.3.load, %B510.endif ], [ %law.3.sroa.238.03135, %B448 ], [ %law.3.sroa.238.03135, %B414 ]
  %law.2.sroa.224.1 = phi i64 [ %.1619.fca.2.2.load, %B510.endif ], [ %law.3.sroa.224.03136, %B448 ], [ %law.3.sroa.224.03136, %B414 ]
  %law.2.sroa.210.1 = phi ptr [ %.1619.fca.2.1.load, %B510.endif ], [ %law.3.sroa.210.03137, %B448 ], [ %law.3.sroa.210.03137, %B414 ]
  %law.2.sroa.196.1 = phi ptr [ %.1619.fca.2.0.load, %B510.endif ], [ %law.3.sroa.196.03138, %B448 ], [ %law.3.sroa.196.03138, %B414 ]
  %law.2.sroa.182.1 = phi i64 [ %.1619.fca.1.6.0.load, %B510.endif ], [ %law.3.sroa.182.03139, %B448 ], [ %law.3.sroa.182.03139, %B414 ]
  %law.2.sroa.168.1 = phi i64 [ %.1619.fca.1.5.0.load, %B510.endif ], [ %law.3.sroa.168.03140, %B448 ], [ %law.3.sroa.168.03140, %B414 ]
  %law.2.sroa.154.1 = phi ptr [ %.1619.fca.1.4.load, %B510.endif ], [ %law.3.sroa.154.03141, %B448 ], [ %law.3.sroa.154.03141, %B414 ]
  %law.2.sroa.140.1 = phi i64 [ %.1619.fca.1.3.load, %B510.endif ], [ %law.3.sroa.140.03142, %B448 ], [ %law.3.sroa.140.03142, %B414 ]
  %law.2.sroa.126.1 = phi i64 [ %.1619.fca.1.2.load, %B510.endif ], [ %law.3.sroa.126.03143, %B448 ], [ %law.3.sroa.126.03143, %B414 ]
  %law.2.sroa.112.1 = phi ptr [ %.1619.fca.1.1.load, %B510.endif ], [ %law.3.sroa.112.03144, %B448 ], [ %law.3.sroa.112.03144, %B414 ]
  %law.2.sroa.98.1 = phi ptr [ %.1619.fca.1.0.load, %B510.endif ], [ %law.3.sroa.98.03145, %B448 ], [ %law.3.sroa.98.03145, %B414 ]
  %law.2.sroa.84.1 = phi i64 [ %.1619.fca.0.6.0.load, %B510.endif ], [ %law.3.sroa.84.03146, %B448 ], [ %law.3.sroa.84.03146, %B414 ]
  %law.2.sroa.70.1 = phi i64 [ %.1619.fca.0.5.0.load, %B510.endif ], [ %law.3.sroa.70.03147, %B448 ], [ %law.3.sroa.70.03147, %B414 ]
  %law.2.sroa.56.1 = phi ptr [ %.1619.fca.0.4.load, %B510.endif ], [ %law.3.sroa.56.03148, %B448 ], [ %law.3.sroa.56.03148, %B414 ]
  %law.2.sroa.42.1 = phi i64 [ %.1619.fca.0.3.load, %B510.endif ], [ %law.3.sroa.42.03149, %B448 ], [ %law.3.sroa.42.03149, %B414 ]
  %law.2.sroa.28.1 = phi i64 [ %.1619.fca.0.2.load, %B510.endif ], [ %law.3.sroa.28.03150, %B448 ], [ %law.3.sroa.28.03150, %B414 ]
  %law.2.sroa.14.1 = phi ptr [ %.1619.fca.0.1.load, %B510.endif ], [ %law.3.sroa.14.03151, %B448 ], [ %law.3.sroa.14.03151, %B414 ]
  %law.2.sroa.0.1 = phi ptr [ %.1619.fca.0.0.load, %B510.endif ], [ %law.3.sroa.0.03152, %B448 ], [ %law.3.sroa.0.03152, %B414 ]
  tail call void @NRT_incref(ptr %arg.track.0.0)
  %.1737 = icmp slt i64 %.1315.0, -1
  %.1738 = select i1 %.1737, i64 %arg.track.2.5.0, i64 0
  %2 = shl i64 %.1738, 3
  %scevgep1858 = getelementptr i8, ptr %scevgep1855, i64 %2
  %3 = shl i64 %.1315.0, 3
  %scevgep1859 = getelementptr i8, ptr %scevgep1858, i64 %3
  %.1753 = load i64, ptr %scevgep1859, align 8
  %.1777 = select i1 %.1737, i64 %arg.track.3.5.0, i64 0
  %4 = shl i64 %.1777, 3
  %scevgep1863 = getelementptr i8, ptr %scevgep1860, i64 %4
  %5 = shl i64 %.1315.0, 3
  %scevgep1864 = getelementptr i8, ptr %scevgep1863, i64 %5
  %.1792 = load i64, ptr %scevgep1864, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(48) %.1820, i8 0, i64 48, i1 false)
  %.1880 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks5_moveB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE54Choice_28int64_2c_20float64_2c_20float64_2c_20int64_29b5TupleI5ArrayIdLi2E1C7mutable7alignedExxEd(ptr nonnull %.1820, ptr nonnull %excinfo.8, double %arg.control.0, ptr %law.2.sroa.0.1, ptr %law.2.sroa.14.1, i64 %law.2.sroa.28.1, i64 %law.2.sroa.42.1, ptr %law.2.sroa.56.1, i64 %law.2.sroa.70.1, i64 %law.2.sroa.84.1, ptr %law.2.sroa.98.1, ptr %law.2.sroa.112.1, i64 %law.2.sroa.126.1, i64 %law.2.sroa.140.1, ptr %law.2.sroa.154.1, i64 %law.2.sroa.168.1, i64 %law.2.sroa.182.1, ptr %law.2.sroa.196.1, ptr %law.2.sroa.210.1, i64 %law.2.sroa.224.1, i64 %law.2.sroa.238.1, ptr %law.2.sroa.252.1, i64 %law.2.sroa.266.1, i64 %law.2.sroa.280.1, double %law.2.sroa.294.1, double %law.2.sroa.308.1, double %law.2.sroa.322.1, ptr %arg.state.0.0.0, ptr %arg.state.0.0.1, i64 %arg.state.0.0.2, i64 %arg.state.0.0.3, ptr %arg.state.0.0.4, i64 %arg.state.0.0.5.0, i64 %arg.state.0.0.5.1, i64 %arg.state.0.0.5.2, i64 %arg.state.0.0.6.0, i64 %arg.state.0.0.6.1, i64 %arg.state.0.0.6.2, ptr %arg.state.0.1.0, ptr %arg.state.0.1.1, i64 %arg.state.0.1.2, i64 %arg.state.0.1.3, ptr %arg.state.0.1.4, i64 %arg.state.0.1.5.0, i64 %arg.state.0.1.6.0, ptr %arg.state.0.2.0, ptr %arg.state.0.2.1, i64 %arg.state.0.2.2, i64 %arg.state.0.2.3, ptr %arg.state.0.2.4, i64 %arg.state.0.2.5.0, i64 %arg.state.0.2.6.0, ptr %arg.state.0.3.0.0, ptr %arg.state.0.3.0.1, i64 %arg.state.0.3.0.2, i64 %arg.state.0.3.0.3, ptr %arg.state.0.3.0.4, i64 %arg.state.0.3.0.5.0, i64 %arg.state.0.3.0.6.0, ptr %arg.state.0.3.1.0, ptr %arg.state.0.3.1.1, i64 %arg.state.0.3.1.2, i64 %arg.state.0.3.1.3, ptr %arg.state.0.3.1.4, i64 %arg.state.0.3.1.5.0, i64 %arg.state.0.3.1.6.0, ptr %arg.state.0.3.2.0, ptr %arg.state.0.3.2.1, i64 %arg.state.0.3.2.2, i64 %arg.state.0.3.2.3, ptr %arg.state.0.3.2.4, i64 %arg.state.0.3.2.5.0, i64 %arg.state.0.3.2.6.0, ptr %arg.state.0.3.3.0, ptr %arg.state.0.3.3.1, i64 %arg.state.0.3.3.2, i64 %arg.state.0.3.3.3, ptr %arg.state.0.3.3.4, i64 %arg.state.0.3.3.5.0, i64 %arg.state.0.3.3.6.0, ptr %arg.state.0.3.4.0, ptr %arg.state.0.3.4.1, i64 %arg.state.0.3.4.2, i64 %arg.state.0.3.4.3, ptr %arg.state.0.3.4.4, i64 %arg.state.0.3.4.5.0, i64 %arg.state.0.3.4.6.0, ptr %arg.state.0.3.5.0, ptr %arg.state.0.3.5.1, i64 %arg.state.0.3.5.2, i64 %arg.state.0.3.5.3, ptr %arg.state.0.3.5.4, i64 %arg.state.0.3.5.5.0, i64 %arg.state.0.3.5.6.0, ptr %p.2.sroa.0.03110, ptr %p.2.sroa.13.03109, i64 %p.2.sroa.26.03108, i64 %p.2.sroa.39.03107, ptr %p.2.sroa.52.03106, i64 %p.2.sroa.65.03105, i64 %p.2.sroa.78.03104, i64 %p.2.sroa.91.03103, i64 %p.2.sroa.104.03102, ptr %older.2.sroa.0.03119, ptr %older.2.sroa.13.03118, i64 %older.2.sroa.26.03117, i64 %older.2.sroa.39.03116, ptr %older.2.sroa.52.03115, i64 %older.2.sroa.65.03114, i64 %older.2.sroa.78.03113, i64 %older.2.sroa.91.03112, i64 %older.2.sroa.104.03111, i64 %.1438, ptr %.874.fca.0.0.load, ptr %.874.fca.0.1.load, i64 %.874.fca.0.2.load, i64 %.874.fca.0.3.load, ptr %.874.fca.0.4.load, i64 %.874.fca.0.5.0.load, i64 %.874.fca.0.6.0.load, ptr %.874.fca.1.0.0.load, ptr %.874.fca.1.0.1.load, i64 %.874.fca.1.0.2.load, i64 %.874.fca.1.0.3.load, ptr %.874.fca.1.0.4.load, i64 %.874.fca.1.0.5.0.load, i64 %.874.fca.1.0.5.1.load, i64 %.874.fca.1.0.6.0.load, i64 %.874.fca.1.0.6.1.load, ptr %.874.fca.1.1.0.load, ptr %.874.fca.1.1.1.load, i64 %.874.fca.1.1.2.load, i64 %.874.fca.1.1.3.load, ptr %.874.fca.1.1.4.load, i64 %.874.fca.1.1.5.0.load, i64 %.874.fca.1.1.6.0.load, ptr %.874.fca.1.2.0.load, ptr %.874.fca.1.2.1.load, i64 %.874.fca.1.2.2.load, i64 %.874.fca.1.2.3.load, ptr %.874.fca.1.2.4.load, i64 %.874.fca.1.2.5.0.load, i64 %.874.fca.1.2.6.0.load, ptr %.874.fca.2.0.load, ptr %.874.fca.2.1.load, i64 %.874.fca.2.2.load, i64 %.874.fca.2.3.load, ptr %.874.fca.2.4.load, i64 %.874.fca.2.5.0.load, i64 %.874.fca.2.6.0.load, ptr %.1003.fca.0.load, ptr %.1003.fca.1.load, i64 %.1003.fca.2.load, i64 %.1003.fca.3.load, ptr %.1003.fca.4.load, i64 %.1003.fca.5.0.load, i64 %.1003.fca.6.0.load, i64 %choice.2.sroa.0.03125, double %choice.2.sroa.11.03124, double %choice.2.sroa.22.03123, i64 %choice.2.sroa.33.03122, i8 0, ptr %arg.track.0.0, ptr %arg.track.0.1, i64 %arg.track.0.2, i64 %arg.track.0.3, ptr %arg.track.0.4, i64 %arg.track.0.5.0, i64 %arg.track.0.5.1, i64 %arg.track.0.6.0, i64 %arg.track.0.6.1, i64 %.1753, i64 %.1792, double %d.2.03120)
  %.1890.fca.0.load = load double, ptr %.1820, align 8
  %sunkaddr1874 = getelementptr inbounds i8, ptr %.1820, i64 16
  %.1890.fca.2.0.load = load i64, ptr %sunkaddr1874, align 8
  %sunkaddr1875 = getelementptr inbounds i8, ptr %.1820, i64 24
  %.1890.fca.2.1.load = load double, ptr %sunkaddr1875, align 8
  %sunkaddr1876 = getelementptr inbounds i8, ptr %.1820, i64 32
  %.1890.fca.2.2.load = load double, ptr %sunkaddr1876, align 8
  %sunkaddr1877 = getelementptr inbounds i8, ptr %.1820, i64 40
  %.1890.fca.2.3.load = load i64, ptr %sunkaddr1877, align 8
  %cond344 = icmp eq i32 %.1880, 0
  tail call void @NRT_decref(ptr %law.3.sroa.0.1)
  tail call void @NRT_decref(ptr %law.3.sroa.98.1)
  tail call void @NRT_decref(ptr %law.3.sroa.196.1)
  br i1 %cond344, label %B564.endif, label %B564.if.if, !prof !0

B998:                                             ; preds = %B564.endif.endif.else.endif.endif.endif, %B564.endif.endif.else.endif.endif.endif.if
  %.2036.sroa.13.0 = phi i64 [ %.2036.sroa.13.1, %B564.endif.endif.else.endif.endif.endif ], [ %.874.fca.0.5.0.load, %B564.endif.endif.else.endif.endif.endif.if ]
  %.2124 = sub i64 %.2036.sroa.13.0, %.2036.sroa.0.3
  %.2133 = tail call i64 @llvm.smax.i64(i64 %.2124, i64 0)
  %.2149 = getelementptr i64, ptr %.874.fca.0.4.load, i64 %.2036.sroa.0.3
  tail call void @NRT_incref(ptr %arg.state.0.3.0.0)
  tail call void @NRT_incref(ptr %arg.state.0.3.1.0)
  tail call void @NRT_incref(ptr %arg.state.0.3.2.0)
  tail call void @NRT_incref(ptr %arg.state.0.3.3.0)
  tail call void @NRT_incref(ptr %arg.state.0.3.4.0)
  tail call void @NRT_incref(ptr %arg.state.0.3.5.0)
  store ptr null, ptr %.2281, align 8
  %.2303 = call i32 @_ZN18elastomer_friction7kernels8rheology6scaled5go_onB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29x(ptr nonnull %.2281, ptr nonnull %excinfo.10, ptr %law.2.sroa.0.1, ptr %law.2.sroa.14.1, i64 %law.2.sroa.28.1, i64 %law.2.sroa.42.1, ptr %law.2.sroa.56.1, i64 %law.2.sroa.70.1, i64 %law.2.sroa.84.1, ptr %law.2.sroa.98.1, ptr %law.2.sroa.112.1, i64 %law.2.sroa.126.1, i64 %law.2.sroa.140.1, ptr %law.2.sroa.154.1, i64 %law.2.sroa.168.1, i64 %law.2.sroa.182.1, ptr %law.2.sroa.196.1, ptr %law.2.sroa.210.1, i64 %law.2.sroa.224.1, i64 %law.2.sroa.238.1, ptr %law.2.sroa.252.1, i64 %law.2.sroa.266.1, i64 %law.2.sroa.280.1, double %law.2.sroa.294.1, double %law.2.sroa.308.1, double %law.2.sroa.322.1, ptr %arg.state.0.3.0.0, ptr %arg.state.0.3.0.1, i64 %arg.state.0.3.0.2, i64 %arg.state.0.3.0.3, ptr %arg.state.0.3.0.4, i64 %arg.state.0.3.0.5.0, i64 %arg.state.0.3.0.6.0, ptr %arg.state.0.3.1.0, ptr %arg.state.0.3.1.1, i64 %arg.state.0.3.1.2, i64 %arg.state.0.3.1.3, ptr %arg.state.0.3.1.4, i64 %arg.state.0.3.1.5.0, i64 %arg.state.0.3.1.6.0, ptr %arg.state.0.3.2.0, ptr %arg.state.0.3.2.1, i64 %arg.state.0.3.2.2, i64 %arg.state.0.3.2.3, ptr %arg.state.0.3.2.4, i64 %arg.state.0.3.2.5.0, i64 %arg.state.0.3.2.6.0, ptr %arg.state.0.3.3.0, ptr %arg.state.0.3.3.1, i64 %arg.state.0.3.3.2, i64 %arg.state.0.3.3.3, ptr %arg.state.0.3.3.4, i64 %arg.state.0.3.3.5.0, i64 %arg.state.0.3.3.6.0, ptr %arg.state.0.3.4.0, ptr %arg.state.0.3.4.1, i64 %arg.state.0.3.4.2, i64 %arg.state.0.3.4.3, ptr %arg.state.0.3.4.4, i64 %arg.state.0.3.4.5.0, i64 %arg.state.0.3.4.6.0, ptr %arg.state.0.3.5.0, ptr %arg.state.0.3.5.1, i64 %arg.state.0.3.5.2, i64 %arg.state.0.3.5.3, ptr %arg.state.0.3.5.4, i64 %arg.state.0.3.5.5.0, i64 %arg.state.0.3.5.6.0, i64 %.1438)
  switch i32 %.2303, label %B998.if.if [
    i32 -2, label %B998.endif
    i32 0, label %B998.endif
  ], !prof !1

B1064:                                            ; preds = %B998.endif
  %.2368 = icmp slt i64 %k.2.03128, 0
  %.2369 = select i1 %.2368, i64 %arg.kept.5.0, i64 0
  %6 = getelementptr i64, ptr %arg.kept.4, i64 %k.2.03128
  %.2383 = getelementptr i64, ptr %6, i64 %.2369
  %.2384 = load i64, ptr %.2383, align 8
  %.2386 = icmp eq i64 %.1438, %.2384
  br label %B1086

B1086:                                            ; preds = %B998.endif, %B1064
  %"$phi1130.1.2.1" = phi i1 [ %.2386, %B1064 ], [ false, %B998.endif ]
  %.2398 = icmp slt i64 %end.2.03126, %arg.ends.2
  br i1 %.2398, label %B1130, label %B1346

B1130:                                            ; preds = %B1086
  %.2417 = icmp slt i64 %end.2.03126, 0
  %.2418 = select i1 %.2417, i64 %arg.ends.5.0, i64 0
  %7 = getelementptr i64, ptr %arg.ends.4, i64 %end.2.03126
  %.2432 = getelementptr i64, ptr %7, i64 %.2418
  %.2433 = load i64, ptr %.2432, align 8
  %.2435 = icmp eq i64 %.1438, %.2433
  br i1 %.2435, label %B1146, label %B1346

B1146:                                            ; preds = %B1130
  store ptr null, ptr %.2471, align 8
  %.2527 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks8_predictB3v41B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_29(ptr nonnull %.2471, ptr nonnull %excinfo.11, ptr %law.2.sroa.0.1, ptr %law.2.sroa.14.1, i64 %law.2.sroa.28.1, i64 %law.2.sroa.42.1, ptr %law.2.sroa.56.1, i64 %law.2.sroa.70.1, i64 %law.2.sroa.84.1, ptr %law.2.sroa.98.1, ptr %law.2.sroa.112.1, i64 %law.2.sroa.126.1, i64 %law.2.sroa.140.1, ptr %law.2.sroa.154.1, i64 %law.2.sroa.168.1, i64 %law.2.sroa.182.1, ptr %law.2.sroa.196.1, ptr %law.2.sroa.210.1, i64 %law.2.sroa.224.1, i64 %law.2.sroa.238.1, ptr %law.2.sroa.252.1, i64 %law.2.sroa.266.1, i64 %law.2.sroa.280.1, double %law.2.sroa.294.1, double %law.2.sroa.308.1, double %law.2.sroa.322.1, ptr %arg.state.0.0.0, ptr %arg.state.0.0.1, i64 %arg.state.0.0.2, i64 %arg.state.0.0.3, ptr %arg.state.0.0.4, i64 %arg.state.0.0.5.0, i64 %arg.state.0.0.5.1, i64 %arg.state.0.0.5.2, i64 %arg.state.0.0.6.0, i64 %arg.state.0.0.6.1, i64 %arg.state.0.0.6.2, ptr %arg.state.0.1.0, ptr %arg.state.0.1.1, i64 %arg.state.0.1.2, i64 %arg.state.0.1.3, ptr %arg.state.0.1.4, i64 %arg.state.0.1.5.0, i64 %arg.state.0.1.6.0, ptr %arg.state.0.2.0, ptr %arg.state.0.2.1, i64 %arg.state.0.2.2, i64 %arg.state.0.2.3, ptr %arg.state.0.2.4, i64 %arg.state.0.2.5.0, i64 %arg.state.0.2.6.0, ptr %arg.state.0.3.0.0, ptr %arg.state.0.3.0.1, i64 %arg.state.0.3.0.2, i64 %arg.state.0.3.0.3, ptr %arg.state.0.3.0.4, i64 %arg.state.0.3.0.5.0, i64 %arg.state.0.3.0.6.0, ptr %arg.state.0.3.1.0, ptr %arg.state.0.3.1.1, i64 %arg.state.0.3.1.2, i64 %arg.state.0.3.1.3, ptr %arg.state.0.3.1.4, i64 %arg.state.0.3.1.5.0, i64 %arg.state.0.3.1.6.0, ptr %arg.state.0.3.2.0, ptr %arg.state.0.3.2.1, i64 %arg.state.0.3.2.2, i64 %arg.state.0.3.2.3, ptr %arg.state.0.3.2.4, i64 %arg.state.0.3.2.5.0, i64 %arg.state.0.3.2.6.0, ptr %arg.state.0.3.3.0, ptr %arg.state.0.3.3.1, i64 %arg.state.0.3.3.2, i64 %arg.state.0.3.3.3, ptr %arg.state.0.3.3.4, i64 %arg.state.0.3.3.5.0, i64 %arg.state.0.3.3.6.0, ptr %arg.state.0.3.4.0, ptr %arg.state.0.3.4.1, i64 %arg.state.0.3.4.2, i64 %arg.state.0.3.4.3, ptr %arg.state.0.3.4.4, i64 %arg.state.0.3.4.5.0, i64 %arg.state.0.3.4.6.0, ptr %arg.state.0.3.5.0, ptr %arg.state.0.3.5.1, i64 %arg.state.0.3.5.2, i64 %arg.state.0.3.5.3, ptr %arg.state.0.3.5.4, i64 %arg.state.0.3.5.5.0, i64 %arg.state.0.3.5.6.0, ptr %older.2.sroa.0.03119, ptr %older.2.sroa.13.03118, i64 %older.2.sroa.26.03117, i64 %older.2.sroa.39.03116, ptr %older.2.sroa.52.03115, i64 %older.2.sroa.65.03114, i64 %older.2.sroa.78.03113, i64 %older.2.sroa.91.03112, i64 %older.2.sroa.104.03111, ptr %p.2.sroa.0.03110, ptr %p.2.sroa.13.03109, i64 %p.2.sroa.26.03108, i64 %p.2.sroa.39.03107, ptr %p.2.sroa.52.03106, i64 %p.2.sroa.65.03105, i64 %p.2.sroa.78.03104, i64 %p.2.sroa.91.03103, i64 %p.2.sroa.104.03102, i64 %.1438, ptr %.874.fca.0.0.load, ptr %.874.fca.0.1.load, i64 %.2133, i64 %.874.fca.0.3.load, ptr %.2149, i64 %.2133, i64 %.874.fca.0.6.0.load, ptr %arg.track.0.0, ptr %arg.track.0.1, i64 %.352.i, i64 %arg.track.0.3, ptr %.376.i, i64 %.352.i, i64 %arg.track.0.6.1, ptr %.874.fca.0.0.load, ptr %.874.fca.0.1.load, i64 %.874.fca.0.2.load, i64 %.874.fca.0.3.load, ptr %.874.fca.0.4.load, i64 %.874.fca.0.5.0.load, i64 %.874.fca.0.6.0.load, ptr %.874.fca.1.0.0.load, ptr %.874.fca.1.0.1.load, i64 %.874.fca.1.0.2.load, i64 %.874.fca.1.0.3.load, ptr %.874.fca.1.0.4.load, i64 %.874.fca.1.0.5.0.load, i64 %.874.fca.1.0.5.1.load, i64 %.874.fca.1.0.6.0.load, i64 %.874.fca.1.0.6.1.load, ptr %.874.fca.1.1.0.load, ptr %.874.fca.1.1.1.load, i64 %.874.fca.1.1.2.load, i64 %.874.fca.1.1.3.load, ptr %.874.fca.1.1.4.load, i64 %.874.fca.1.1.5.0.load, i64 %.874.fca.1.1.6.0.load, ptr %.874.fca.1.2.0.load, ptr %.874.fca.1.2.1.load, i64 %.874.fca.1.2.2.load, i64 %.874.fca.1.2.3.load, ptr %.874.fca.1.2.4.load, i64 %.874.fca.1.2.5.0.load, i64 %.874.fca.1.2.6.0.load, ptr %.874.fca.2.0.load, ptr %.874.fca.2.1.load, i64 %.874.fca.2.2.load, i64 %.874.fca.2.3.load, ptr %.874.fca.2.4.load, i64 %.874.fca.2.5.0.load, i64 %.874.fca.2.6.0.load)
  %cond345 = icmp eq i32 %.2527, 0
  br i1 %cond345, label %B1346, label %B1146.if.if, !prof !0

B1346:                                            ; preds = %B1146, %B1130, %B1086
  %"$phi1130.2.2.12595" = phi i1 [ false, %B1130 ], [ true, %B1146 ], [ false, %B1086 ]
  tail call void @NRT_decref(ptr %arg.track.0.0)
  br i1 %"$phi1130.1.2.1", label %B1350, label %B1414

B1350:                                            ; preds = %B1346
  store ptr null, ptr %.2577, align 8
  %.2661 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks5_keepB3v60B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEx102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29xdd368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29vv(ptr nonnull %.2577, ptr nonnull %excinfo.12, i64 %k.2.03128, double %arg.form.0, ptr %arg.form.1.0, ptr %arg.form.1.1, i64 %arg.form.1.2, i64 %arg.form.1.3, ptr %arg.form.1.4, i64 %arg.form.1.5.0, i64 %arg.form.1.6.0, ptr %arg.form.2.0, ptr %arg.form.2.1, i64 %arg.form.2.2, i64 %arg.form.2.3, ptr %arg.form.2.4, i64 %arg.form.2.5.0, i64 %arg.form.2.6.0, ptr %law.2.sroa.0.1, ptr %law.2.sroa.14.1, i64 %law.2.sroa.28.1, i64 %law.2.sroa.42.1, ptr %law.2.sroa.56.1, i64 %law.2.sroa.70.1, i64 %law.2.sroa.84.1, ptr %law.2.sroa.98.1, ptr %law.2.sroa.112.1, i64 %law.2.sroa.126.1, i64 %law.2.sroa.140.1, ptr %law.2.sroa.154.1, i64 %law.2.sroa.168.1, i64 %law.2.sroa.182.1, ptr %law.2.sroa.196.1, ptr %law.2.sroa.210.1, i64 %law.2.sroa.224.1, i64 %law.2.sroa.238.1, ptr %law.2.sroa.252.1, i64 %law.2.sroa.266.1, i64 %law.2.sroa.280.1, double %law.2.sroa.294.1, double %law.2.sroa.308.1, double %law.2.sroa.322.1, ptr %arg.track.0.0, ptr %arg.track.0.1, i64 %arg.track.0.2, i64 %arg.track.0.3, ptr %arg.track.0.4, i64 %arg.track.0.5.0, i64 %arg.track.0.5.1, i64 %arg.track.0.6.0, i64 %arg.track.0.6.1, ptr %arg.track.1.0, ptr %arg.track.1.1, i64 %arg.track.1.2, i64 %arg.track.1.3, ptr %arg.track.1.4, i64 %arg.track.1.5.0, i64 %arg.track.1.5.1, i64 %arg.track.1.6.0, i64 %arg.track.1.6.1, ptr %arg.track.2.0, ptr %arg.track.2.1, i64 %arg.track.2.2, i64 %arg.track.2.3, ptr nonnull %scevgep1868, i64 %arg.track.2.5.0, i64 %arg.track.2.6.0, ptr %arg.track.3.0, ptr %arg.track.3.1, i64 %arg.track.3.2, i64 %arg.track.3.3, ptr nonnull %scevgep1866, i64 %arg.track.3.5.0, i64 %arg.track.3.6.0, ptr %arg.track.4.0, ptr %arg.track.4.1, i64 %arg.track.4.2, i64 %arg.track.4.3, ptr nonnull %arg.track.4.4, i64 %arg.track.4.5.0, i64 %arg.track.4.6.0, ptr %arg.track.5.0, ptr %arg.track.5.1, i64 %arg.track.5.2, i64 %arg.track.5.3, ptr %arg.track.5.4, i64 %arg.track.5.5.0, i64 %arg.track.5.6.0, ptr %arg.track.6.0, ptr %arg.track.6.1, i64 %arg.track.6.2, i64 %arg.track.6.3, ptr %arg.track.6.4, i64 %arg.track.6.5.0, i64 %arg.track.6.6.0, i64 %.1315.0, double %d.2.03120, double %.1890.fca.0.load, ptr %arg.state.0.0.0, ptr %arg.state.0.0.1, i64 %arg.state.0.0.2, i64 %arg.state.0.0.3, ptr %arg.state.0.0.4, i64 %arg.state.0.0.5.0, i64 %arg.state.0.0.5.1, i64 %arg.state.0.0.5.2, i64 %arg.state.0.0.6.0, i64 %arg.state.0.0.6.1, i64 %arg.state.0.0.6.2, ptr %arg.state.0.1.0, ptr %arg.state.0.1.1, i64 %arg.state.0.1.2, i64 %arg.state.0.1.3, ptr %arg.state.0.1.4, i64 %arg.state.0.1.5.0, i64 %arg.state.0.1.6.0, ptr %arg.state.0.2.0, ptr %arg.state.0.2.1, i64 %arg.state.0.2.2, i64 %arg.state.0.2.3, ptr %arg.state.0.2.4, i64 %arg.state.0.2.5.0, i64 %arg.state.0.2.6.0, ptr %arg.state.0.3.0.0, ptr %arg.state.0.3.0.1, i64 %arg.state.0.3.0.2, i64 %arg.state.0.3.0.3, ptr %arg.state.0.3.0.4, i64 %arg.state.0.3.0.5.0, i64 %arg.state.0.3.0.6.0, ptr %arg.state.0.3.1.0, ptr %arg.state.0.3.1.1, i64 %arg.state.0.3.1.2, i64 %arg.state.0.3.1.3, ptr %arg.state.0.3.1.4, i64 %arg.state.0.3.1.5.0, i64 %arg.state.0.3.1.6.0, ptr %arg.state.0.3.2.0, ptr %arg.state.0.3.2.1, i64 %arg.state.0.3.2.2, i64 %arg.state.0.3.2.3, ptr %arg.state.0.3.2.4, i64 %arg.state.0.3.2.5.0, i64 %arg.state.0.3.2.6.0, ptr %arg.state.0.3.3.0, ptr %arg.state.0.3.3.1, i64 %arg.state.0.3.3.2, i64 %arg.state.0.3.3.3, ptr %arg.state.0.3.3.4, i64 %arg.state.0.3.3.5.0, i64 %arg.state.0.3.3.6.0, ptr %arg.state.0.3.4.0, ptr %arg.state.0.3.4.1, i64 %arg.state.0.3.4.2, i64 %arg.state.0.3.4.3, ptr %arg.state.0.3.4.4, i64 %arg.state.0.3.4.5.0, i64 %arg.state.0.3.4.6.0, ptr %arg.state.0.3.5.0, ptr %arg.state.0.3.5.1, i64 %arg.state.0.3.5.2, i64 %arg.state.0.3.5.3, ptr %arg.state.0.3.5.4, i64 %arg.state.0.3.5.5.0, i64 %arg.state.0.3.5.6.0, ptr %.874.fca.0.0.load, ptr %.874.fca.0.1.load, i64 %.2133, i64 %.874.fca.0.3.load, ptr %.2149, i64 %.2133, i64 %.874.fca.0.6.0.load, ptr %older.2.sroa.0.03119, ptr %older.2.sroa.13.03118, i64 %older.2.sroa.26.03117, i64 %older.2.sroa.39.03116, ptr %older.2.sroa.52.03115, i64 %older.2.sroa.65.03114, i64 %older.2.sroa.78.03113, i64 %older.2.sroa.91.03112, i64 %older.2.sroa.104.03111, ptr %arg.trace.0.0, ptr %arg.trace.0.1, i64 %arg.trace.0.2, i64 %arg.trace.0.3, ptr %arg.trace.0.4, i64 %arg.trace.0.5.0, i64 %arg.trace.0.6.0, ptr %arg.trace.1.0, ptr %arg.trace.1.1, i64 %arg.trace.1.2, i64 %arg.trace.1.3, ptr %arg.trace.1.4, i64 %arg.trace.1.5.0, i64 %arg.trace.1.6.0, ptr %arg.trace.2.0, ptr %arg.trace.2.1, i64 %arg.trace.2.2, i64 %arg.trace.2.3, ptr %arg.trace.2.4, i64 %arg.trace.2.5.0, i64 %arg.trace.2.6.0, ptr %arg.trace.3.0, ptr %arg.trace.3.1, i64 %arg.trace.3.2, i64 %arg.trace.3.3, ptr %arg.trace.3.4, i64 %arg.trace.3.5.0, i64 %arg.trace.3.6.0, ptr %arg.trace.4.0, ptr %arg.trace.4.1, i64 %arg.trace.4.2, i64 %arg.trace.4.3, ptr %arg.trace.4.4, i64 %arg.trace.4.5.0, i64 %arg.trace.4.6.0, ptr %arg.trace.5.0, ptr %arg.trace.5.1, i64 %arg.trace.5.2, i64 %arg.trace.5.3, ptr %arg.trace.5.4, i64 %arg.trace.5.5.0, i64 %arg.trace.5.6.0, ptr %arg.trace.6.0, ptr %arg.trace.6.1, i64 %arg.trace.6.2, i64 %arg.trace.6.3, ptr %arg.trace.6.4, i64 %arg.trace.6.5.0, i64 %arg.trace.6.6.0, ptr %arg.trace.7.0, ptr %arg.trace.7.1, i64 %arg.trace.7.2, i64 %arg.trace.7.3, ptr %arg.trace.7.4, i64 %arg.trace.7.5.0, i64 %arg.trace.7.6.0, ptr %arg.ledger, ptr %arg.lengths)
  %cond346 = icmp eq i32 %.2661, 0
  br i1 %cond346, label %B1350.endif, label %B1350.if.if, !prof !0

B1414:                                            ; preds = %B1350.endif, %B1346
  %some.sroa.0.1 = phi ptr [ null, %B1350.endif ], [ %.874.fca.0.0.load, %B1346 ]
  %k.3.1 = phi i64 [ %.2691, %B1350.endif ], [ %k.2.03128, %B1346 ]
  tail call void @NRT_decref(ptr %some.sroa.0.1)
  br i1 %"$phi1130.2.2.12595", label %B1418, label %B1460

B1418:                                            ; preds = %B1414
  store ptr null, ptr %.2719, align 8
  %.2745 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks15_count_as_it_isB3v69B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_29x(ptr nonnull %.2719, ptr nonnull %excinfo.13, ptr %arg.state.0.0.0, ptr %arg.state.0.0.1, i64 %arg.state.0.0.2, i64 %arg.state.0.0.3, ptr %arg.state.0.0.4, i64 %arg.state.0.0.5.0, i64 %arg.state.0.0.5.1, i64 %arg.state.0.0.5.2, i64 %arg.state.0.0.6.0, i64 %arg.state.0.0.6.1, i64 %arg.state.0.0.6.2, ptr %arg.state.0.1.0, ptr %arg.state.0.1.1, i64 %arg.state.0.1.2, i64 %arg.state.0.1.3, ptr %arg.state.0.1.4, i64 %arg.state.0.1.5.0, i64 %arg.state.0.1.6.0, ptr %arg.state.0.2.0, ptr %arg.state.0.2.1, i64 %arg.state.0.2.2, i64 %arg.state.0.2.3, ptr %arg.state.0.2.4, i64 %arg.state.0.2.5.0, i64 %arg.state.0.2.6.0, ptr %arg.state.0.3.0.0, ptr %arg.state.0.3.0.1, i64 %arg.state.0.3.0.2, i64 %arg.state.0.3.0.3, ptr %arg.state.0.3.0.4, i64 %arg.state.0.3.0.5.0, i64 %arg.state.0.3.0.6.0, ptr %arg.state.0.3.1.0, ptr %arg.state.0.3.1.1, i64 %arg.state.0.3.1.2, i64 %arg.state.0.3.1.3, ptr %arg.state.0.3.1.4, i64 %arg.state.0.3.1.5.0, i64 %arg.state.0.3.1.6.0, ptr %arg.state.0.3.2.0, ptr %arg.state.0.3.2.1, i64 %arg.state.0.3.2.2, i64 %arg.state.0.3.2.3, ptr %arg.state.0.3.2.4, i64 %arg.state.0.3.2.5.0, i64 %arg.state.0.3.2.6.0, ptr %arg.state.0.3.3.0, ptr %arg.state.0.3.3.1, i64 %arg.state.0.3.3.2, i64 %arg.state.0.3.3.3, ptr %arg.state.0.3.3.4, i64 %arg.state.0.3.3.5.0, i64 %arg.state.0.3.3.6.0, ptr %arg.state.0.3.4.0, ptr %arg.state.0.3.4.1, i64 %arg.state.0.3.4.2, i64 %arg.state.0.3.4.3, ptr %arg.state.0.3.4.4, i64 %arg.state.0.3.4.5.0, i64 %arg.state.0.3.4.6.0, ptr %arg.state.0.3.5.0, ptr %arg.state.0.3.5.1, i64 %arg.state.0.3.5.2, i64 %arg.state.0.3.5.3, ptr %arg.state.0.3.5.4, i64 %arg.state.0.3.5.5.0, i64 %arg.state.0.3.5.6.0, i64 %.1438)
  %cond347 = icmp eq i32 %.2745, 0
  br i1 %cond347, label %B1418.endif, label %B1418.if.if, !prof !0

B1460:                                            ; preds = %B1418.endif, %B1414
  %end.3.1 = phi i64 [ %.2768, %B1418.endif ], [ %end.2.03126, %B1414 ]
  %exitcond.not = icmp eq i64 %arg.track.4.2, %.1385
  br i1 %exitcond.not, label %B1464.else, label %B414

B0.endif.endif:                                   ; preds = %B0.else.if
  %.fca.4.gep936 = getelementptr inbounds nuw i8, ptr %.985, i64 32
  %.fca.3.gep935 = getelementptr inbounds nuw i8, ptr %.985, i64 24
  %.fca.2.gep934 = getelementptr inbounds nuw i8, ptr %.985, i64 16
  %.fca.1.gep933 = getelementptr inbounds nuw i8, ptr %.985, i64 8
  tail call void @NRT_incref(ptr %arg.track.0.0)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.985, i8 0, i64 56, i1 false)
  %.993 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks7_lowestB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE(ptr nonnull %.985, ptr nonnull %excinfo.2, ptr %arg.track.0.0, ptr %arg.track.0.1, i64 %arg.track.0.2, i64 %arg.track.0.3, ptr %arg.track.0.4, i64 %arg.track.0.5.0, i64 %arg.track.0.5.1, i64 %arg.track.0.6.0, i64 %arg.track.0.6.1)
  %.1003.fca.0.load = load ptr, ptr %.985, align 8
  %.1003.fca.1.load = load ptr, ptr %.fca.1.gep933, align 8
  %.1003.fca.2.load = load i64, ptr %.fca.2.gep934, align 8
  %.1003.fca.3.load = load i64, ptr %.fca.3.gep935, align 8
  %.1003.fca.4.load = load ptr, ptr %.fca.4.gep936, align 8
  %cond303 = icmp eq i32 %.993, 0
  br i1 %cond303, label %B0.endif.endif.endif, label %B0.endif.endif.if.if, !prof !0

common.ret:                                       ; preds = %B1464.endif.endif.if.if, %B1464.endif.endif.endif, %B1418.if.if, %B1350.if.if, %B1146.if.if, %B998.if.if, %B564.if.if, %B510.if.if, %B0.endif.endif.endif.endif.endif.endif.if.if, %B0.endif.endif.if.if, %B0.endif.if.if
  %common.ret.op = phi i32 [ 1, %B0.endif.if.if ], [ 1, %B0.endif.endif.if.if ], [ %.3444, %B1464.endif.endif.if.if ], [ 0, %B1464.endif.endif.endif ], [ %.2745, %B1418.if.if ], [ %.1189, %B0.endif.endif.endif.endif.endif.endif.if.if ], [ %.1609, %B510.if.if ], [ %.1880, %B564.if.if ], [ %.2661, %B1350.if.if ], [ %.2303, %B998.if.if ], [ %.2527, %B1146.if.if ]
  ret i32 %common.ret.op

B0.endif.if.if:                                   ; preds = %B0.else.if
  %.865 = load ptr, ptr %excinfo.1, align 8
  store ptr %.865, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif:                             ; preds = %B0.endif.endif
  %sunkaddr1878 = getelementptr inbounds i8, ptr %.985, i64 40
  %.1003.fca.5.0.load = load i64, ptr %sunkaddr1878, align 8
  %sunkaddr1879 = getelementptr inbounds i8, ptr %.985, i64 48
  %.1003.fca.6.0.load = load i64, ptr %sunkaddr1879, align 8
  %.36.i = icmp sgt i64 %arg.kept.2, 0
  br i1 %.36.i, label %B30.i, label %B0.endif.endif.endif.endif

B30.i:                                            ; preds = %B0.endif.endif.endif
  %.75.i = load i64, ptr %arg.kept.4, align 8, !noalias !2
  %.79.not.i = icmp sgt i64 %.75.i, %arg.done
  br i1 %.79.not.i, label %B0.endif.endif.endif.endif, label %B54.preheader.i

B54.preheader.i:                                  ; preds = %B30.i
  %8 = add i64 %arg.kept.2, -1
  br label %B54.i

B54.i:                                            ; preds = %B86.i, %B54.preheader.i
  %k.2.1.i = phi i64 [ %.85.i, %B86.i ], [ 0, %B54.preheader.i ]
  %exitcond.not.i = icmp eq i64 %8, %k.2.1.i
  br i1 %exitcond.not.i, label %B0.endif.endif.endif.endif, label %B86.i

B86.i:                                            ; preds = %B54.i
  %.85.i = add nuw nsw i64 %k.2.1.i, 1
  %sunkaddr1880 = mul i64 %k.2.1.i, 8
  %sunkaddr1881 = getelementptr i8, ptr %arg.kept.4, i64 %sunkaddr1880
  %sunkaddr1882 = getelementptr i8, ptr %sunkaddr1881, i64 8
  %.140.i = load i64, ptr %sunkaddr1882, align 8, !noalias !2
  %.144.not.i = icmp sgt i64 %.140.i, %arg.done
  br i1 %.144.not.i, label %B0.endif.endif.endif.endif, label %B54.i

B0.endif.endif.if.if:                             ; preds = %B0.endif.endif
  %.994 = load ptr, ptr %excinfo.2, align 8
  store ptr %.994, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif:                       ; preds = %B54.i, %B86.i, %B30.i, %B0.endif.endif.endif
  %k.3.0.i = phi i64 [ 0, %B30.i ], [ 0, %B0.endif.endif.endif ], [ %arg.kept.2, %B54.i ], [ %.85.i, %B86.i ]
  tail call void @NRT_decref(ptr %arg.track.0.0)
  tail call void @NRT_decref(ptr %arg.frames.0)
  %.36.i319 = icmp sgt i64 %arg.ends.2, 0
  br i1 %.36.i319, label %B30.i321, label %B0.endif.endif.endif.endif.endif.endif

B30.i321:                                         ; preds = %B0.endif.endif.endif.endif
  %.75.i322 = load i64, ptr %arg.ends.4, align 8, !noalias !5
  %.79.not.i323 = icmp sgt i64 %.75.i322, %arg.done
  br i1 %.79.not.i323, label %B0.endif.endif.endif.endif.endif.endif, label %B54.preheader.i324

B54.preheader.i324:                               ; preds = %B30.i321
  %9 = add i64 %arg.ends.2, -1
  br label %B54.i325

B54.i325:                                         ; preds = %B86.i328, %B54.preheader.i324
  %k.2.1.i326 = phi i64 [ %.85.i329, %B86.i328 ], [ 0, %B54.preheader.i324 ]
  %exitcond.not.i327 = icmp eq i64 %9, %k.2.1.i326
  br i1 %exitcond.not.i327, label %B0.endif.endif.endif.endif.endif.endif, label %B86.i328

B86.i328:                                         ; preds = %B54.i325
  %.85.i329 = add nuw nsw i64 %k.2.1.i326, 1
  %sunkaddr1883 = mul i64 %k.2.1.i326, 8
  %sunkaddr1884 = getelementptr i8, ptr %arg.ends.4, i64 %sunkaddr1883
  %sunkaddr1885 = getelementptr i8, ptr %sunkaddr1884, i64 8
  %.140.i331 = load i64, ptr %sunkaddr1885, align 8, !noalias !5
  %.144.not.i332 = icmp sgt i64 %.140.i331, %arg.done
  br i1 %.144.not.i332, label %B0.endif.endif.endif.endif.endif.endif, label %B54.i325

B0.endif.endif.endif.endif.endif.endif:           ; preds = %B54.i325, %B86.i328, %B30.i321, %B0.endif.endif.endif.endif
  %k.3.0.i320 = phi i64 [ 0, %B30.i321 ], [ 0, %B0.endif.endif.endif.endif ], [ %arg.ends.2, %B54.i325 ], [ %.85.i329, %B86.i328 ]
  %.1176 = load double, ptr %arg.track.4.4, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(192) %.1181, i8 0, i64 192, i1 false)
  %.1189 = call i32 @_ZN18elastomer_friction7kernels8rheology5prony7_law_ofB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29d(ptr nonnull %.1181, ptr nonnull %excinfo.6, double %arg.form.0, ptr %arg.form.1.0, ptr %arg.form.1.1, i64 %arg.form.1.2, i64 %arg.form.1.3, ptr %arg.form.1.4, i64 %arg.form.1.5.0, i64 %arg.form.1.6.0, ptr %arg.form.2.0, ptr %arg.form.2.1, i64 %arg.form.2.2, i64 %arg.form.2.3, ptr %arg.form.2.4, i64 %arg.form.2.5.0, i64 %arg.form.2.6.0, double %.1176)
  %sunkaddr1886 = getelementptr inbounds i8, ptr %.1181, i64 168
  %.1199.fca.3.load = load double, ptr %sunkaddr1886, align 8
  %sunkaddr1887 = getelementptr inbounds i8, ptr %.1181, i64 176
  %.1199.fca.4.load = load double, ptr %sunkaddr1887, align 8
  %sunkaddr1888 = getelementptr inbounds i8, ptr %.1181, i64 184
  %.1199.fca.5.load = load double, ptr %sunkaddr1888, align 8
  %cond341 = icmp eq i32 %.1189, 0
  br i1 %cond341, label %B0.endif.endif.endif.endif.endif.endif.endif.endif, label %B0.endif.endif.endif.endif.endif.endif.if.if, !prof !0

B0.endif.endif.endif.endif.endif.endif.if.if:     ; preds = %B0.endif.endif.endif.endif.endif.endif
  %.1197 = icmp sgt i32 %.1189, 0
  %.1190 = load ptr, ptr %excinfo.6, align 8
  %.1198 = select i1 %.1197, ptr %.1190, ptr undef
  store ptr %.1198, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif.endif.endif.endif.endif: ; preds = %B0.endif.endif.endif.endif.endif.endif
  %.1199.fca.0.0.load = load ptr, ptr %.1181, align 8
  %sunkaddr1889 = getelementptr inbounds i8, ptr %.1181, i64 8
  %.1199.fca.0.1.load = load ptr, ptr %sunkaddr1889, align 8
  %sunkaddr1890 = getelementptr inbounds i8, ptr %.1181, i64 16
  %.1199.fca.0.2.load = load i64, ptr %sunkaddr1890, align 8
  %sunkaddr1891 = getelementptr inbounds i8, ptr %.1181, i64 24
  %.1199.fca.0.3.load = load i64, ptr %sunkaddr1891, align 8
  %sunkaddr1892 = getelementptr inbounds i8, ptr %.1181, i64 32
  %.1199.fca.0.4.load = load ptr, ptr %sunkaddr1892, align 8
  %sunkaddr1893 = getelementptr inbounds i8, ptr %.1181, i64 40
  %.1199.fca.0.5.0.load = load i64, ptr %sunkaddr1893, align 8
  %sunkaddr1894 = getelementptr inbounds i8, ptr %.1181, i64 48
  %.1199.fca.0.6.0.load = load i64, ptr %sunkaddr1894, align 8
  %sunkaddr1895 = getelementptr inbounds i8, ptr %.1181, i64 56
  %.1199.fca.1.0.load = load ptr, ptr %sunkaddr1895, align 8
  %sunkaddr1896 = getelementptr inbounds i8, ptr %.1181, i64 64
  %.1199.fca.1.1.load = load ptr, ptr %sunkaddr1896, align 8
  %sunkaddr1897 = getelementptr inbounds i8, ptr %.1181, i64 72
  %.1199.fca.1.2.load = load i64, ptr %sunkaddr1897, align 8
  %sunkaddr1898 = getelementptr inbounds i8, ptr %.1181, i64 80
  %.1199.fca.1.3.load = load i64, ptr %sunkaddr1898, align 8
  %sunkaddr1899 = getelementptr inbounds i8, ptr %.1181, i64 88
  %.1199.fca.1.4.load = load ptr, ptr %sunkaddr1899, align 8
  %sunkaddr1900 = getelementptr inbounds i8, ptr %.1181, i64 96
  %.1199.fca.1.5.0.load = load i64, ptr %sunkaddr1900, align 8
  %sunkaddr1901 = getelementptr inbounds i8, ptr %.1181, i64 104
  %.1199.fca.1.6.0.load = load i64, ptr %sunkaddr1901, align 8
  %sunkaddr1902 = getelementptr inbounds i8, ptr %.1181, i64 112
  %.1199.fca.2.0.load = load ptr, ptr %sunkaddr1902, align 8
  %sunkaddr1903 = getelementptr inbounds i8, ptr %.1181, i64 120
  %.1199.fca.2.1.load = load ptr, ptr %sunkaddr1903, align 8
  %sunkaddr1904 = getelementptr inbounds i8, ptr %.1181, i64 128
  %.1199.fca.2.2.load = load i64, ptr %sunkaddr1904, align 8
  %sunkaddr1905 = getelementptr inbounds i8, ptr %.1181, i64 136
  %.1199.fca.2.3.load = load i64, ptr %sunkaddr1905, align 8
  %sunkaddr1906 = getelementptr inbounds i8, ptr %.1181, i64 144
  %.1199.fca.2.4.load = load ptr, ptr %sunkaddr1906, align 8
  %sunkaddr1907 = getelementptr inbounds i8, ptr %.1181, i64 152
  %.1199.fca.2.5.0.load = load i64, ptr %sunkaddr1907, align 8
  %sunkaddr1908 = getelementptr inbounds i8, ptr %.1181, i64 160
  %.1199.fca.2.6.0.load = load i64, ptr %sunkaddr1908, align 8
  %.13723101.not = icmp slt i64 %arg.track.4.2, 1
  br i1 %.13723101.not, label %B1464.else, label %B414.lr.ph

B414.lr.ph:                                       ; preds = %B0.endif.endif.endif.endif.endif.endif.endif.endif
  %.1437 = add i64 %arg.done, 1
  %scevgep1855 = getelementptr i8, ptr %arg.track.2.4, i64 8
  %scevgep1860 = getelementptr i8, ptr %arg.track.3.4, i64 8
  br label %B414

B510.endif:                                       ; preds = %B510
  %.1619.fca.0.0.load = load ptr, ptr %.1601, align 8
  %sunkaddr1909 = getelementptr inbounds i8, ptr %.1601, i64 8
  %.1619.fca.0.1.load = load ptr, ptr %sunkaddr1909, align 8
  %sunkaddr1910 = getelementptr inbounds i8, ptr %.1601, i64 16
  %.1619.fca.0.2.load = load i64, ptr %sunkaddr1910, align 8
  %sunkaddr1911 = getelementptr inbounds i8, ptr %.1601, i64 24
  %.1619.fca.0.3.load = load i64, ptr %sunkaddr1911, align 8
  %sunkaddr1912 = getelementptr inbounds i8, ptr %.1601, i64 32
  %.1619.fca.0.4.load = load ptr, ptr %sunkaddr1912, align 8
  %sunkaddr1913 = getelementptr inbounds i8, ptr %.1601, i64 40
  %.1619.fca.0.5.0.load = load i64, ptr %sunkaddr1913, align 8
  %sunkaddr1914 = getelementptr inbounds i8, ptr %.1601, i64 48
  %.1619.fca.0.6.0.load = load i64, ptr %sunkaddr1914, align 8
  %sunkaddr1915 = getelementptr inbounds i8, ptr %.1601, i64 56
  %.1619.fca.1.0.load = load ptr, ptr %sunkaddr1915, align 8
  %sunkaddr1916 = getelementptr inbounds i8, ptr %.1601, i64 64
  %.1619.fca.1.1.load = load ptr, ptr %sunkaddr1916, align 8
  %sunkaddr1917 = getelementptr inbounds i8, ptr %.1601, i64 72
  %.1619.fca.1.2.load = load i64, ptr %sunkaddr1917, align 8
  %sunkaddr1918 = getelementptr inbounds i8, ptr %.1601, i64 80
  %.1619.fca.1.3.load = load i64, ptr %sunkaddr1918, align 8
  %sunkaddr1919 = getelementptr inbounds i8, ptr %.1601, i64 88
  %.1619.fca.1.4.load = load ptr, ptr %sunkaddr1919, align 8
  %sunkaddr1920 = getelementptr inbounds i8, ptr %.1601, i64 96
  %.1619.fca.1.5.0.load = load i64, ptr %sunkaddr1920, align 8
  %sunkaddr1921 = getelementptr inbounds i8, ptr %.1601, i64 104
  %.1619.fca.1.6.0.load = load i64, ptr %sunkaddr1921, align 8
  %sunkaddr1922 = getelementptr inbounds i8, ptr %.1601, i64 112
  %.1619.fca.2.0.load = load ptr, ptr %sunkaddr1922, align 8
  %sunkaddr1923 = getelementptr inbounds i8, ptr %.1601, i64 120
  %.1619.fca.2.1.load = load ptr, ptr %sunkaddr1923, align 8
  %sunkaddr1924 = getelementptr inbounds i8, ptr %.1601, i64 128
  %.1619.fca.2.2.load = load i64, ptr %sunkaddr1924, align 8
  %sunkaddr1925 = getelementptr inbounds i8, ptr %.1601, i64 136
  %.1619.fca.2.3.load = load i64, ptr %sunkaddr1925, align 8
  %sunkaddr1926 = getelementptr inbounds i8, ptr %.1601, i64 144
  %.1619.fca.2.4.load = load ptr, ptr %sunkaddr1926, align 8
  %sunkaddr1927 = getelementptr inbounds i8, ptr %.1601, i64 152
  %.1619.fca.2.5.0.load = load i64, ptr %sunkaddr1927, align 8
  %sunkaddr1928 = getelementptr inbounds i8, ptr %.1601, i64 160
  %.1619.fca.2.6.0.load = load i64, ptr %sunkaddr1928, align 8
  %sunkaddr1929 = getelementptr inbounds i8, ptr %.1601, i64 168
  %.1619.fca.3.load = load double, ptr %sunkaddr1929, align 8
  %sunkaddr1930 = getelementptr inbounds i8, ptr %.1601, i64 176
  %.1619.fca.4.load = load double, ptr %sunkaddr1930, align 8
  %sunkaddr1931 = getelementptr inbounds i8, ptr %.1601, i64 184
  %.1619.fca.5.load = load double, ptr %sunkaddr1931, align 8
  tail call void @NRT_decref(ptr %law.3.sroa.0.03152)
  tail call void @NRT_decref(ptr %law.3.sroa.98.03145)
  tail call void @NRT_decref(ptr %law.3.sroa.196.03138)
  br label %B564

B510.if.if:                                       ; preds = %B510
  %.1617 = icmp sgt i32 %.1609, 0
  %.1610 = load ptr, ptr %excinfo.7, align 8
  %.1618 = select i1 %.1617, ptr %.1610, ptr undef
  store ptr %.1618, ptr %excinfo, align 8
  br label %common.ret

B564.endif:                                       ; preds = %B564
  %sunkaddr1932 = getelementptr inbounds i8, ptr %.1820, i64 8
  %.1890.fca.1.load = load i64, ptr %sunkaddr1932, align 8
  %.1924 = add nsw i64 %.1890.fca.1.load, %passes.2.03121
  %.136.i = icmp slt i64 %0, 0
  %.137.i = select i1 %.136.i, i64 %arg.track.3.5.0, i64 0
  %10 = shl i64 %.137.i, 3
  %scevgep1861 = getelementptr i8, ptr %scevgep1860, i64 %10
  %11 = shl i64 %.1315.0, 3
  %scevgep1862 = getelementptr i8, ptr %scevgep1861, i64 %11
  %.152.i = load i64, ptr %scevgep1862, align 8, !noalias !8
  %.198.i = select i1 %.136.i, i64 %arg.track.2.5.0, i64 0
  %12 = shl i64 %.198.i, 3
  %scevgep1856 = getelementptr i8, ptr %scevgep1855, i64 %12
  %13 = shl i64 %.1315.0, 3
  %scevgep1857 = getelementptr i8, ptr %scevgep1856, i64 %13
  %.213.i = load i64, ptr %scevgep1857, align 8, !noalias !8
  %.217.i = add nsw i64 %.152.i, %.812.1
  %.265.i = icmp slt i64 %.152.i, 0
  %.266.i = select i1 %.265.i, i64 %arg.track.0.5.1, i64 0
  %.267.i = add i64 %.266.i, %.152.i
  %.270.i = icmp slt i64 %.267.i, 0
  br i1 %.270.i, label %B0.else.if.i, label %B0.else.endif.i, !prof !11

B0.else.if.i:                                     ; preds = %B564.endif
  br label %B0.else.endif.i

B0.else.endif.i:                                  ; preds = %B0.else.if.i, %B564.endif
  %.255.sroa.0.1.i = phi i64 [ 0, %B0.else.if.i ], [ %.267.i, %B564.endif ]
  %.275.not.i = icmp slt i64 %.267.i, %arg.track.0.5.1
  br i1 %.275.not.i, label %B0.else.endif.endif.i, label %B0.else.endif.if.i, !prof !12

B0.else.endif.if.i:                               ; preds = %B0.else.endif.i
  br label %B0.else.endif.endif.i

B0.else.endif.endif.i:                            ; preds = %B0.else.endif.if.i, %B0.else.endif.i
  %.255.sroa.0.3.i = phi i64 [ %arg.track.0.5.1, %B0.else.endif.if.i ], [ %.255.sroa.0.1.i, %B0.else.endif.i ]
  %.282.i = icmp slt i64 %.217.i, 0
  %.283.i = select i1 %.282.i, i64 %arg.track.0.5.1, i64 0
  %.284.i = add i64 %.283.i, %.217.i
  %.287.i = icmp slt i64 %.284.i, 0
  br i1 %.287.i, label %B0.else.endif.endif.if.i, label %B0.else.endif.endif.endif.i, !prof !11

B0.else.endif.endif.if.i:                         ; preds = %B0.else.endif.endif.i
  br label %B0.else.endif.endif.endif.i

B0.else.endif.endif.endif.i:                      ; preds = %B0.else.endif.endif.if.i, %B0.else.endif.endif.i
  %.255.sroa.13.1.i = phi i64 [ 0, %B0.else.endif.endif.if.i ], [ %.284.i, %B0.else.endif.endif.i ]
  %.292.not.i = icmp slt i64 %.284.i, %arg.track.0.5.1
  br i1 %.292.not.i, label %B564.endif.endif.else, label %B0.else.endif.endif.endif.if.i, !prof !12

B0.else.endif.endif.endif.if.i:                   ; preds = %B0.else.endif.endif.endif.i
  br label %B564.endif.endif.else

B564.if.if:                                       ; preds = %B564
  %.1888 = icmp sgt i32 %.1880, 0
  %.1881 = load ptr, ptr %excinfo.8, align 8
  %.1889 = select i1 %.1888, ptr %.1881, ptr undef
  store ptr %.1889, ptr %excinfo, align 8
  br label %common.ret

B564.endif.endif.else:                            ; preds = %B0.else.endif.endif.endif.if.i, %B0.else.endif.endif.endif.i
  %.255.sroa.13.0.i = phi i64 [ %.255.sroa.13.1.i, %B0.else.endif.endif.endif.i ], [ %arg.track.0.5.1, %B0.else.endif.endif.endif.if.i ]
  %14 = icmp slt i64 %.874.fca.0.5.0.load, 1
  %.252.i = icmp slt i64 %.213.i, 0
  %.253.i = select i1 %.252.i, i64 %arg.track.0.5.0, i64 0
  %.254.i = add i64 %.253.i, %.213.i
  %.343.i = sub i64 %.255.sroa.13.0.i, %.255.sroa.0.3.i
  %.352.i = tail call i64 @llvm.smax.i64(i64 %.343.i, i64 0)
  %.372.i = mul i64 %.254.i, %arg.track.0.5.1
  %15 = getelementptr double, ptr %arg.track.0.4, i64 %.372.i
  %.376.i = getelementptr double, ptr %15, i64 %.255.sroa.0.3.i
  tail call void @NRT_incref(ptr %.874.fca.0.0.load)
  br i1 %14, label %B564.endif.endif.else.endif.if, label %B564.endif.endif.else.endif.endif, !prof !11

B564.endif.endif.else.endif.if:                   ; preds = %B564.endif.endif.else
  br label %B564.endif.endif.else.endif.endif

B564.endif.endif.else.endif.endif:                ; preds = %B564.endif.endif.else.endif.if, %B564.endif.endif.else
  %.2036.sroa.0.3 = phi i64 [ %.874.fca.0.5.0.load, %B564.endif.endif.else.endif.if ], [ 0, %B564.endif.endif.else ]
  %.2063 = icmp slt i64 %.1890.fca.2.3.load, 0
  %.2064 = select i1 %.2063, i64 %.874.fca.0.5.0.load, i64 0
  %.2065 = add i64 %.2064, %.1890.fca.2.3.load
  %.2068 = icmp slt i64 %.2065, 0
  br i1 %.2068, label %B564.endif.endif.else.endif.endif.if, label %B564.endif.endif.else.endif.endif.endif, !prof !11

B564.endif.endif.else.endif.endif.if:             ; preds = %B564.endif.endif.else.endif.endif
  br label %B564.endif.endif.else.endif.endif.endif

B564.endif.endif.else.endif.endif.endif:          ; preds = %B564.endif.endif.else.endif.endif.if, %B564.endif.endif.else.endif.endif
  %.2036.sroa.13.1 = phi i64 [ 0, %B564.endif.endif.else.endif.endif.if ], [ %.2065, %B564.endif.endif.else.endif.endif ]
  %.2073.not = icmp slt i64 %.2065, %.874.fca.0.5.0.load
  br i1 %.2073.not, label %B998, label %B564.endif.endif.else.endif.endif.endif.if, !prof !12

B564.endif.endif.else.endif.endif.endif.if:       ; preds = %B564.endif.endif.else.endif.endif.endif
  br label %B998

B998.endif:                                       ; preds = %B998, %B998
  tail call void @NRT_decref(ptr %arg.state.0.3.0.0)
  tail call void @NRT_decref(ptr %arg.state.0.3.1.0)
  tail call void @NRT_decref(ptr %arg.state.0.3.2.0)
  tail call void @NRT_decref(ptr %arg.state.0.3.3.0)
  tail call void @NRT_decref(ptr %arg.state.0.3.4.0)
  tail call void @NRT_decref(ptr %arg.state.0.3.5.0)
  %.2349 = icmp slt i64 %k.2.03128, %arg.kept.2
  br i1 %.2349, label %B1064, label %B1086

B998.if.if:                                       ; preds = %B998
  store ptr null, ptr %excinfo, align 8
  br label %common.ret

B1146.if.if:                                      ; preds = %B1146
  %.2535 = icmp sgt i32 %.2527, 0
  %.2528 = load ptr, ptr %excinfo.11, align 8
  %.2536 = select i1 %.2535, ptr %.2528, ptr undef
  store ptr %.2536, ptr %excinfo, align 8
  br label %common.ret

B1350.endif:                                      ; preds = %B1350
  tail call void @NRT_decref(ptr %.874.fca.0.0.load)
  %.2691 = add nsw i64 %k.2.03128, 1
  br label %B1414

B1350.if.if:                                      ; preds = %B1350
  %.2669 = icmp sgt i32 %.2661, 0
  %.2662 = load ptr, ptr %excinfo.12, align 8
  %.2670 = select i1 %.2669, ptr %.2662, ptr undef
  store ptr %.2670, ptr %excinfo, align 8
  br label %common.ret

B1418.endif:                                      ; preds = %B1418
  %.2768 = add nsw i64 %end.2.03126, 1
  br label %B1460

B1418.if.if:                                      ; preds = %B1418
  %.2753 = icmp sgt i32 %.2745, 0
  %.2746 = load ptr, ptr %excinfo.13, align 8
  %.2754 = select i1 %.2753, ptr %.2746, ptr undef
  store ptr %.2754, ptr %excinfo, align 8
  br label %common.ret

B1464.else:                                       ; preds = %B1460, %B0.endif.endif.endif.endif.endif.endif.endif.endif
  %p.2.sroa.104.0.lcssa = phi i64 [ %arg.state.1.6.1, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %older.2.sroa.104.03111, %B1460 ]
  %p.2.sroa.91.0.lcssa = phi i64 [ %arg.state.1.6.0, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %older.2.sroa.91.03112, %B1460 ]
  %p.2.sroa.78.0.lcssa = phi i64 [ %arg.state.1.5.1, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %older.2.sroa.78.03113, %B1460 ]
  %p.2.sroa.65.0.lcssa = phi i64 [ %arg.state.1.5.0, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %older.2.sroa.65.03114, %B1460 ]
  %p.2.sroa.52.0.lcssa = phi ptr [ %arg.state.1.4, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %older.2.sroa.52.03115, %B1460 ]
  %p.2.sroa.39.0.lcssa = phi i64 [ %arg.state.1.3, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %older.2.sroa.39.03116, %B1460 ]
  %p.2.sroa.26.0.lcssa = phi i64 [ %arg.state.1.2, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %older.2.sroa.26.03117, %B1460 ]
  %p.2.sroa.13.0.lcssa = phi ptr [ %arg.state.1.1, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %older.2.sroa.13.03118, %B1460 ]
  %p.2.sroa.0.0.lcssa = phi ptr [ %arg.state.1.0, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %older.2.sroa.0.03119, %B1460 ]
  %older.2.sroa.104.0.lcssa = phi i64 [ %arg.state.2.6.1, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %p.2.sroa.104.03102, %B1460 ]
  %older.2.sroa.91.0.lcssa = phi i64 [ %arg.state.2.6.0, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %p.2.sroa.91.03103, %B1460 ]
  %older.2.sroa.78.0.lcssa = phi i64 [ %arg.state.2.5.1, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %p.2.sroa.78.03104, %B1460 ]
  %older.2.sroa.65.0.lcssa = phi i64 [ %arg.state.2.5.0, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %p.2.sroa.65.03105, %B1460 ]
  %older.2.sroa.52.0.lcssa = phi ptr [ %arg.state.2.4, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %p.2.sroa.52.03106, %B1460 ]
  %older.2.sroa.39.0.lcssa = phi i64 [ %arg.state.2.3, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %p.2.sroa.39.03107, %B1460 ]
  %older.2.sroa.26.0.lcssa = phi i64 [ %arg.state.2.2, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %p.2.sroa.26.03108, %B1460 ]
  %older.2.sroa.13.0.lcssa = phi ptr [ %arg.state.2.1, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %p.2.sroa.13.03109, %B1460 ]
  %older.2.sroa.0.0.lcssa = phi ptr [ %arg.state.2.0, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %p.2.sroa.0.03110, %B1460 ]
  %d.2.0.lcssa = phi double [ %arg.state.3, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %.1890.fca.0.load, %B1460 ]
  %passes.2.0.lcssa = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %.1924, %B1460 ]
  %choice.2.sroa.33.0.lcssa = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %.1890.fca.2.3.load, %B1460 ]
  %law.3.sroa.322.0.lcssa = phi double [ %.1199.fca.5.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.322.1, %B1460 ]
  %law.3.sroa.308.0.lcssa = phi double [ %.1199.fca.4.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.308.1, %B1460 ]
  %law.3.sroa.294.0.lcssa = phi double [ %.1199.fca.3.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.294.1, %B1460 ]
  %law.3.sroa.280.0.lcssa = phi i64 [ %.1199.fca.2.6.0.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.280.1, %B1460 ]
  %law.3.sroa.266.0.lcssa = phi i64 [ %.1199.fca.2.5.0.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.266.1, %B1460 ]
  %law.3.sroa.252.0.lcssa = phi ptr [ %.1199.fca.2.4.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.252.1, %B1460 ]
  %law.3.sroa.238.0.lcssa = phi i64 [ %.1199.fca.2.3.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.238.1, %B1460 ]
  %law.3.sroa.224.0.lcssa = phi i64 [ %.1199.fca.2.2.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.224.1, %B1460 ]
  %law.3.sroa.210.0.lcssa = phi ptr [ %.1199.fca.2.1.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.210.1, %B1460 ]
  %law.3.sroa.196.0.lcssa = phi ptr [ %.1199.fca.2.0.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.196.1, %B1460 ]
  %law.3.sroa.182.0.lcssa = phi i64 [ %.1199.fca.1.6.0.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.182.1, %B1460 ]
  %law.3.sroa.168.0.lcssa = phi i64 [ %.1199.fca.1.5.0.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.168.1, %B1460 ]
  %law.3.sroa.154.0.lcssa = phi ptr [ %.1199.fca.1.4.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.154.1, %B1460 ]
  %law.3.sroa.140.0.lcssa = phi i64 [ %.1199.fca.1.3.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.140.1, %B1460 ]
  %law.3.sroa.126.0.lcssa = phi i64 [ %.1199.fca.1.2.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.126.1, %B1460 ]
  %law.3.sroa.112.0.lcssa = phi ptr [ %.1199.fca.1.1.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.112.1, %B1460 ]
  %law.3.sroa.98.0.lcssa = phi ptr [ %.1199.fca.1.0.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.98.1, %B1460 ]
  %law.3.sroa.84.0.lcssa = phi i64 [ %.1199.fca.0.6.0.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.84.1, %B1460 ]
  %law.3.sroa.70.0.lcssa = phi i64 [ %.1199.fca.0.5.0.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.70.1, %B1460 ]
  %law.3.sroa.56.0.lcssa = phi ptr [ %.1199.fca.0.4.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.56.1, %B1460 ]
  %law.3.sroa.42.0.lcssa = phi i64 [ %.1199.fca.0.3.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.42.1, %B1460 ]
  %law.3.sroa.28.0.lcssa = phi i64 [ %.1199.fca.0.2.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.28.1, %B1460 ]
  %law.3.sroa.14.0.lcssa = phi ptr [ %.1199.fca.0.1.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.14.1, %B1460 ]
  %law.3.sroa.0.0.lcssa = phi ptr [ %.1199.fca.0.0.load, %B0.endif.endif.endif.endif.endif.endif.endif.endif ], [ %law.2.sroa.0.1, %B1460 ]
  tail call void @NRT_incref(ptr %.874.fca.0.0.load)
  %.3000 = icmp slt i64 %.874.fca.0.5.0.load, 1
  tail call void @NRT_decref(ptr %arg.trace.0.0)
  tail call void @NRT_decref(ptr %arg.trace.1.0)
  tail call void @NRT_decref(ptr %arg.trace.2.0)
  tail call void @NRT_decref(ptr %arg.trace.3.0)
  tail call void @NRT_decref(ptr %arg.trace.4.0)
  tail call void @NRT_decref(ptr %arg.trace.5.0)
  tail call void @NRT_decref(ptr %arg.trace.6.0)
  tail call void @NRT_decref(ptr %arg.trace.7.0)
  tail call void @NRT_decref(ptr %.1003.fca.0.load)
  tail call void @NRT_decref(ptr %arg.kept.0)
  tail call void @NRT_decref(ptr %arg.form.1.0)
  tail call void @NRT_decref(ptr %arg.form.2.0)
  tail call void @NRT_decref(ptr %arg.ends.0)
  br i1 %.3000, label %B1464.else.endif.if, label %B1464.else.endif.endif, !prof !11

B1464.else.endif.if:                              ; preds = %B1464.else
  br label %B1464.else.endif.endif

B1464.else.endif.endif:                           ; preds = %B1464.else.endif.if, %B1464.else
  %.2980.sroa.0.3 = phi i64 [ %.874.fca.0.5.0.load, %B1464.else.endif.if ], [ 0, %B1464.else ]
  %.3007 = icmp slt i64 %choice.2.sroa.33.0.lcssa, 0
  %.3008 = select i1 %.3007, i64 %.874.fca.0.5.0.load, i64 0
  %.3009 = add i64 %.3008, %choice.2.sroa.33.0.lcssa
  %.3012 = icmp slt i64 %.3009, 0
  br i1 %.3012, label %B1464.else.endif.endif.if, label %B1464.else.endif.endif.endif, !prof !11

B1464.else.endif.endif.if:                        ; preds = %B1464.else.endif.endif
  br label %B1464.else.endif.endif.endif

B1464.else.endif.endif.endif:                     ; preds = %B1464.else.endif.endif.if, %B1464.else.endif.endif
  %.2980.sroa.13.1 = phi i64 [ 0, %B1464.else.endif.endif.if ], [ %.3009, %B1464.else.endif.endif ]
  %.3017.not = icmp slt i64 %.3009, %.874.fca.0.5.0.load
  br i1 %.3017.not, label %B1464.endif.else, label %B1464.else.endif.endif.endif.if, !prof !12

B1464.else.endif.endif.endif.if:                  ; preds = %B1464.else.endif.endif.endif
  br label %B1464.endif.else

B1464.endif.else:                                 ; preds = %B1464.else.endif.endif.endif.if, %B1464.else.endif.endif.endif
  %.2980.sroa.13.0 = phi i64 [ %.2980.sroa.13.1, %B1464.else.endif.endif.endif ], [ %.874.fca.0.5.0.load, %B1464.else.endif.endif.endif.if ]
  %.3068 = sub i64 %.2980.sroa.13.0, %.2980.sroa.0.3
  %.3077 = tail call i64 @llvm.smax.i64(i64 %.3068, i64 0)
  %.3093 = getelementptr i64, ptr %.874.fca.0.4.load, i64 %.2980.sroa.0.3
  %.3144 = add nsw i64 %arg.done, %arg.track.4.2
  %.3245 = icmp slt i64 %arg.track.0.5.1, 1
  tail call void @NRT_decref(ptr %arg.track.1.0)
  tail call void @NRT_decref(ptr %arg.track.2.0)
  tail call void @NRT_decref(ptr %arg.track.3.0)
  tail call void @NRT_decref(ptr %arg.track.4.0)
  tail call void @NRT_decref(ptr %arg.track.5.0)
  tail call void @NRT_decref(ptr %arg.track.6.0)
  br i1 %.3245, label %B1464.endif.else.endif.if, label %B1464.endif.else.endif.endif, !prof !11

B1464.endif.endif:                                ; preds = %B1464.endif.else.endif.endif.endif, %B1464.endif.else.endif.endif.endif.if
  %.3225.sroa.13.0 = phi i64 [ %.3225.sroa.13.1, %B1464.endif.else.endif.endif.endif ], [ %arg.track.0.5.1, %B1464.endif.else.endif.endif.endif.if ]
  %.3313 = sub i64 %.3225.sroa.13.0, %.3225.sroa.0.3
  %.3322 = tail call i64 @llvm.smax.i64(i64 %.3313, i64 0)
  %.3346 = getelementptr double, ptr %arg.track.0.4, i64 %.3225.sroa.0.3
  store ptr null, ptr %.3388, align 8
  %.3444 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks8_predictB3v41B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_29(ptr nonnull %.3388, ptr nonnull %excinfo.14, ptr %law.3.sroa.0.0.lcssa, ptr %law.3.sroa.14.0.lcssa, i64 %law.3.sroa.28.0.lcssa, i64 %law.3.sroa.42.0.lcssa, ptr %law.3.sroa.56.0.lcssa, i64 %law.3.sroa.70.0.lcssa, i64 %law.3.sroa.84.0.lcssa, ptr %law.3.sroa.98.0.lcssa, ptr %law.3.sroa.112.0.lcssa, i64 %law.3.sroa.126.0.lcssa, i64 %law.3.sroa.140.0.lcssa, ptr %law.3.sroa.154.0.lcssa, i64 %law.3.sroa.168.0.lcssa, i64 %law.3.sroa.182.0.lcssa, ptr %law.3.sroa.196.0.lcssa, ptr %law.3.sroa.210.0.lcssa, i64 %law.3.sroa.224.0.lcssa, i64 %law.3.sroa.238.0.lcssa, ptr %law.3.sroa.252.0.lcssa, i64 %law.3.sroa.266.0.lcssa, i64 %law.3.sroa.280.0.lcssa, double %law.3.sroa.294.0.lcssa, double %law.3.sroa.308.0.lcssa, double %law.3.sroa.322.0.lcssa, ptr %arg.state.0.0.0, ptr %arg.state.0.0.1, i64 %arg.state.0.0.2, i64 %arg.state.0.0.3, ptr %arg.state.0.0.4, i64 %arg.state.0.0.5.0, i64 %arg.state.0.0.5.1, i64 %arg.state.0.0.5.2, i64 %arg.state.0.0.6.0, i64 %arg.state.0.0.6.1, i64 %arg.state.0.0.6.2, ptr %arg.state.0.1.0, ptr %arg.state.0.1.1, i64 %arg.state.0.1.2, i64 %arg.state.0.1.3, ptr %arg.state.0.1.4, i64 %arg.state.0.1.5.0, i64 %arg.state.0.1.6.0, ptr %arg.state.0.2.0, ptr %arg.state.0.2.1, i64 %arg.state.0.2.2, i64 %arg.state.0.2.3, ptr %arg.state.0.2.4, i64 %arg.state.0.2.5.0, i64 %arg.state.0.2.6.0, ptr %arg.state.0.3.0.0, ptr %arg.state.0.3.0.1, i64 %arg.state.0.3.0.2, i64 %arg.state.0.3.0.3, ptr %arg.state.0.3.0.4, i64 %arg.state.0.3.0.5.0, i64 %arg.state.0.3.0.6.0, ptr %arg.state.0.3.1.0, ptr %arg.state.0.3.1.1, i64 %arg.state.0.3.1.2, i64 %arg.state.0.3.1.3, ptr %arg.state.0.3.1.4, i64 %arg.state.0.3.1.5.0, i64 %arg.state.0.3.1.6.0, ptr %arg.state.0.3.2.0, ptr %arg.state.0.3.2.1, i64 %arg.state.0.3.2.2, i64 %arg.state.0.3.2.3, ptr %arg.state.0.3.2.4, i64 %arg.state.0.3.2.5.0, i64 %arg.state.0.3.2.6.0, ptr %arg.state.0.3.3.0, ptr %arg.state.0.3.3.1, i64 %arg.state.0.3.3.2, i64 %arg.state.0.3.3.3, ptr %arg.state.0.3.3.4, i64 %arg.state.0.3.3.5.0, i64 %arg.state.0.3.3.6.0, ptr %arg.state.0.3.4.0, ptr %arg.state.0.3.4.1, i64 %arg.state.0.3.4.2, i64 %arg.state.0.3.4.3, ptr %arg.state.0.3.4.4, i64 %arg.state.0.3.4.5.0, i64 %arg.state.0.3.4.6.0, ptr %arg.state.0.3.5.0, ptr %arg.state.0.3.5.1, i64 %arg.state.0.3.5.2, i64 %arg.state.0.3.5.3, ptr %arg.state.0.3.5.4, i64 %arg.state.0.3.5.5.0, i64 %arg.state.0.3.5.6.0, ptr %p.2.sroa.0.0.lcssa, ptr %p.2.sroa.13.0.lcssa, i64 %p.2.sroa.26.0.lcssa, i64 %p.2.sroa.39.0.lcssa, ptr %p.2.sroa.52.0.lcssa, i64 %p.2.sroa.65.0.lcssa, i64 %p.2.sroa.78.0.lcssa, i64 %p.2.sroa.91.0.lcssa, i64 %p.2.sroa.104.0.lcssa, ptr %older.2.sroa.0.0.lcssa, ptr %older.2.sroa.13.0.lcssa, i64 %older.2.sroa.26.0.lcssa, i64 %older.2.sroa.39.0.lcssa, ptr %older.2.sroa.52.0.lcssa, i64 %older.2.sroa.65.0.lcssa, i64 %older.2.sroa.78.0.lcssa, i64 %older.2.sroa.91.0.lcssa, i64 %older.2.sroa.104.0.lcssa, i64 %.3144, ptr %.874.fca.0.0.load, ptr %.874.fca.0.1.load, i64 %.3077, i64 %.874.fca.0.3.load, ptr %.3093, i64 %.3077, i64 %.874.fca.0.6.0.load, ptr %arg.track.0.0, ptr %arg.track.0.1, i64 %.3322, i64 %arg.track.0.3, ptr %.3346, i64 %.3322, i64 %arg.track.0.6.1, ptr %.874.fca.0.0.load, ptr %.874.fca.0.1.load, i64 %.874.fca.0.2.load, i64 %.874.fca.0.3.load, ptr %.874.fca.0.4.load, i64 %.874.fca.0.5.0.load, i64 %.874.fca.0.6.0.load, ptr %.874.fca.1.0.0.load, ptr %.874.fca.1.0.1.load, i64 %.874.fca.1.0.2.load, i64 %.874.fca.1.0.3.load, ptr %.874.fca.1.0.4.load, i64 %.874.fca.1.0.5.0.load, i64 %.874.fca.1.0.5.1.load, i64 %.874.fca.1.0.6.0.load, i64 %.874.fca.1.0.6.1.load, ptr %.874.fca.1.1.0.load, ptr %.874.fca.1.1.1.load, i64 %.874.fca.1.1.2.load, i64 %.874.fca.1.1.3.load, ptr %.874.fca.1.1.4.load, i64 %.874.fca.1.1.5.0.load, i64 %.874.fca.1.1.6.0.load, ptr %.874.fca.1.2.0.load, ptr %.874.fca.1.2.1.load, i64 %.874.fca.1.2.2.load, i64 %.874.fca.1.2.3.load, ptr %.874.fca.1.2.4.load, i64 %.874.fca.1.2.5.0.load, i64 %.874.fca.1.2.6.0.load, ptr %.874.fca.2.0.load, ptr %.874.fca.2.1.load, i64 %.874.fca.2.2.load, i64 %.874.fca.2.3.load, ptr %.874.fca.2.4.load, i64 %.874.fca.2.5.0.load, i64 %.874.fca.2.6.0.load)
  %cond342 = icmp eq i32 %.3444, 0
  br i1 %cond342, label %B1464.endif.endif.endif, label %B1464.endif.endif.if.if, !prof !0

B1464.endif.else.endif.if:                        ; preds = %B1464.endif.else
  br label %B1464.endif.else.endif.endif

B1464.endif.else.endif.endif:                     ; preds = %B1464.endif.else.endif.if, %B1464.endif.else
  %.3225.sroa.0.3 = phi i64 [ %arg.track.0.5.1, %B1464.endif.else.endif.if ], [ 0, %B1464.endif.else ]
  %.3252 = icmp slt i64 %.812.1, 0
  %.3253 = select i1 %.3252, i64 %arg.track.0.5.1, i64 0
  %.3254 = add i64 %.3253, %.812.1
  %.3257 = icmp slt i64 %.3254, 0
  br i1 %.3257, label %B1464.endif.else.endif.endif.if, label %B1464.endif.else.endif.endif.endif, !prof !11

B1464.endif.else.endif.endif.if:                  ; preds = %B1464.endif.else.endif.endif
  br label %B1464.endif.else.endif.endif.endif

B1464.endif.else.endif.endif.endif:               ; preds = %B1464.endif.else.endif.endif.if, %B1464.endif.else.endif.endif
  %.3225.sroa.13.1 = phi i64 [ 0, %B1464.endif.else.endif.endif.if ], [ %.3254, %B1464.endif.else.endif.endif ]
  %.3262.not = icmp slt i64 %.3254, %arg.track.0.5.1
  br i1 %.3262.not, label %B1464.endif.endif, label %B1464.endif.else.endif.endif.endif.if, !prof !12

B1464.endif.else.endif.endif.endif.if:            ; preds = %B1464.endif.else.endif.endif.endif
  br label %B1464.endif.endif

B1464.endif.endif.endif:                          ; preds = %B1464.endif.endif
  store ptr %arg.state.0.0.0, ptr %retptr, align 8
  %retptr.repack2615 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store ptr %arg.state.0.0.1, ptr %retptr.repack2615, align 8
  %retptr.repack2617 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store i64 %arg.state.0.0.2, ptr %retptr.repack2617, align 8
  %retptr.repack2619 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store i64 %arg.state.0.0.3, ptr %retptr.repack2619, align 8
  %retptr.repack2621 = getelementptr inbounds nuw i8, ptr %retptr, i64 32
  store ptr %arg.state.0.0.4, ptr %retptr.repack2621, align 8
  %retptr.repack2623 = getelementptr inbounds nuw i8, ptr %retptr, i64 40
  store i64 %arg.state.0.0.5.0, ptr %retptr.repack2623, align 8
  %retptr.repack2623.repack2627 = getelementptr inbounds nuw i8, ptr %retptr, i64 48
  store i64 %arg.state.0.0.5.1, ptr %retptr.repack2623.repack2627, align 8
  %retptr.repack2623.repack2629 = getelementptr inbounds nuw i8, ptr %retptr, i64 56
  store i64 %arg.state.0.0.5.2, ptr %retptr.repack2623.repack2629, align 8
  %retptr.repack2625 = getelementptr inbounds nuw i8, ptr %retptr, i64 64
  store i64 %arg.state.0.0.6.0, ptr %retptr.repack2625, align 8
  %retptr.repack2625.repack2631 = getelementptr inbounds nuw i8, ptr %retptr, i64 72
  store i64 %arg.state.0.0.6.1, ptr %retptr.repack2625.repack2631, align 8
  %retptr.repack2625.repack2633 = getelementptr inbounds nuw i8, ptr %retptr, i64 80
  store i64 %arg.state.0.0.6.2, ptr %retptr.repack2625.repack2633, align 8
  %retptr.repack2609 = getelementptr inbounds nuw i8, ptr %retptr, i64 88
  store ptr %arg.state.0.1.0, ptr %retptr.repack2609, align 8
  %retptr.repack2609.repack2635 = getelementptr inbounds nuw i8, ptr %retptr, i64 96
  store ptr %arg.state.0.1.1, ptr %retptr.repack2609.repack2635, align 8
  %retptr.repack2609.repack2637 = getelementptr inbounds nuw i8, ptr %retptr, i64 104
  store i64 %arg.state.0.1.2, ptr %retptr.repack2609.repack2637, align 8
  %retptr.repack2609.repack2639 = getelementptr inbounds nuw i8, ptr %retptr, i64 112
  store i64 %arg.state.0.1.3, ptr %retptr.repack2609.repack2639, align 8
  %retptr.repack2609.repack2641 = getelementptr inbounds nuw i8, ptr %retptr, i64 120
  store ptr %arg.state.0.1.4, ptr %retptr.repack2609.repack2641, align 8
  %retptr.repack2609.repack2643 = getelementptr inbounds nuw i8, ptr %retptr, i64 128
  store i64 %arg.state.0.1.5.0, ptr %retptr.repack2609.repack2643, align 8
  %retptr.repack2609.repack2645 = getelementptr inbounds nuw i8, ptr %retptr, i64 136
  store i64 %arg.state.0.1.6.0, ptr %retptr.repack2609.repack2645, align 8
  %retptr.repack2611 = getelementptr inbounds nuw i8, ptr %retptr, i64 144
  store ptr %arg.state.0.2.0, ptr %retptr.repack2611, align 8
  %retptr.repack2611.repack2647 = getelementptr inbounds nuw i8, ptr %retptr, i64 152
  store ptr %arg.state.0.2.1, ptr %retptr.repack2611.repack2647, align 8
  %retptr.repack2611.repack2649 = getelementptr inbounds nuw i8, ptr %retptr, i64 160
  store i64 %arg.state.0.2.2, ptr %retptr.repack2611.repack2649, align 8
  %retptr.repack2611.repack2651 = getelementptr inbounds nuw i8, ptr %retptr, i64 168
  store i64 %arg.state.0.2.3, ptr %retptr.repack2611.repack2651, align 8
  %retptr.repack2611.repack2653 = getelementptr inbounds nuw i8, ptr %retptr, i64 176
  store ptr %arg.state.0.2.4, ptr %retptr.repack2611.repack2653, align 8
  %retptr.repack2611.repack2655 = getelementptr inbounds nuw i8, ptr %retptr, i64 184
  store i64 %arg.state.0.2.5.0, ptr %retptr.repack2611.repack2655, align 8
  %retptr.repack2611.repack2657 = getelementptr inbounds nuw i8, ptr %retptr, i64 192
  store i64 %arg.state.0.2.6.0, ptr %retptr.repack2611.repack2657, align 8
  %retptr.repack2613 = getelementptr inbounds nuw i8, ptr %retptr, i64 200
  store ptr %arg.state.0.3.0.0, ptr %retptr.repack2613, align 8
  %retptr.repack2613.repack2669 = getelementptr inbounds nuw i8, ptr %retptr, i64 208
  store ptr %arg.state.0.3.0.1, ptr %retptr.repack2613.repack2669, align 8
  %retptr.repack2613.repack2671 = getelementptr inbounds nuw i8, ptr %retptr, i64 216
  store i64 %arg.state.0.3.0.2, ptr %retptr.repack2613.repack2671, align 8
  %retptr.repack2613.repack2673 = getelementptr inbounds nuw i8, ptr %retptr, i64 224
  store i64 %arg.state.0.3.0.3, ptr %retptr.repack2613.repack2673, align 8
  %retptr.repack2613.repack2675 = getelementptr inbounds nuw i8, ptr %retptr, i64 232
  store ptr %arg.state.0.3.0.4, ptr %retptr.repack2613.repack2675, align 8
  %retptr.repack2613.repack2677 = getelementptr inbounds nuw i8, ptr %retptr, i64 240
  store i64 %arg.state.0.3.0.5.0, ptr %retptr.repack2613.repack2677, align 8
  %retptr.repack2613.repack2679 = getelementptr inbounds nuw i8, ptr %retptr, i64 248
  store i64 %arg.state.0.3.0.6.0, ptr %retptr.repack2613.repack2679, align 8
  %retptr.repack2613.repack2659 = getelementptr inbounds nuw i8, ptr %retptr, i64 256
  store ptr %arg.state.0.3.1.0, ptr %retptr.repack2613.repack2659, align 8
  %retptr.repack2613.repack2659.repack2681 = getelementptr inbounds nuw i8, ptr %retptr, i64 264
  store ptr %arg.state.0.3.1.1, ptr %retptr.repack2613.repack2659.repack2681, align 8
  %retptr.repack2613.repack2659.repack2683 = getelementptr inbounds nuw i8, ptr %retptr, i64 272
  store i64 %arg.state.0.3.1.2, ptr %retptr.repack2613.repack2659.repack2683, align 8
  %retptr.repack2613.repack2659.repack2685 = getelementptr inbounds nuw i8, ptr %retptr, i64 280
  store i64 %arg.state.0.3.1.3, ptr %retptr.repack2613.repack2659.repack2685, align 8
  %retptr.repack2613.repack2659.repack2687 = getelementptr inbounds nuw i8, ptr %retptr, i64 288
  store ptr %arg.state.0.3.1.4, ptr %retptr.repack2613.repack2659.repack2687, align 8
  %retptr.repack2613.repack2659.repack2689 = getelementptr inbounds nuw i8, ptr %retptr, i64 296
  store i64 %arg.state.0.3.1.5.0, ptr %retptr.repack2613.repack2659.repack2689, align 8
  %retptr.repack2613.repack2659.repack2691 = getelementptr inbounds nuw i8, ptr %retptr, i64 304
  store i64 %arg.state.0.3.1.6.0, ptr %retptr.repack2613.repack2659.repack2691, align 8
  %retptr.repack2613.repack2661 = getelementptr inbounds nuw i8, ptr %retptr, i64 312
  store ptr %arg.state.0.3.2.0, ptr %retptr.repack2613.repack2661, align 8
  %retptr.repack2613.repack2661.repack2693 = getelementptr inbounds nuw i8, ptr %retptr, i64 320
  store ptr %arg.state.0.3.2.1, ptr %retptr.repack2613.repack2661.repack2693, align 8
  %retptr.repack2613.repack2661.repack2695 = getelementptr inbounds nuw i8, ptr %retptr, i64 328
  store i64 %arg.state.0.3.2.2, ptr %retptr.repack2613.repack2661.repack2695, align 8
  %retptr.repack2613.repack2661.repack2697 = getelementptr inbounds nuw i8, ptr %retptr, i64 336
  store i64 %arg.state.0.3.2.3, ptr %retptr.repack2613.repack2661.repack2697, align 8
  %retptr.repack2613.repack2661.repack2699 = getelementptr inbounds nuw i8, ptr %retptr, i64 344
  store ptr %arg.state.0.3.2.4, ptr %retptr.repack2613.repack2661.repack2699, align 8
  %retptr.repack2613.repack2661.repack2701 = getelementptr inbounds nuw i8, ptr %retptr, i64 352
  store i64 %arg.state.0.3.2.5.0, ptr %retptr.repack2613.repack2661.repack2701, align 8
  %retptr.repack2613.repack2661.repack2703 = getelementptr inbounds nuw i8, ptr %retptr, i64 360
  store i64 %arg.state.0.3.2.6.0, ptr %retptr.repack2613.repack2661.repack2703, align 8
  %retptr.repack2613.repack2663 = getelementptr inbounds nuw i8, ptr %retptr, i64 368
  store ptr %arg.state.0.3.3.0, ptr %retptr.repack2613.repack2663, align 8
  %retptr.repack2613.repack2663.repack2705 = getelementptr inbounds nuw i8, ptr %retptr, i64 376
  store ptr %arg.state.0.3.3.1, ptr %retptr.repack2613.repack2663.repack2705, align 8
  %retptr.repack2613.repack2663.repack2707 = getelementptr inbounds nuw i8, ptr %retptr, i64 384
  store i64 %arg.state.0.3.3.2, ptr %retptr.repack2613.repack2663.repack2707, align 8
  %retptr.repack2613.repack2663.repack2709 = getelementptr inbounds nuw i8, ptr %retptr, i64 392
  store i64 %arg.state.0.3.3.3, ptr %retptr.repack2613.repack2663.repack2709, align 8
  %retptr.repack2613.repack2663.repack2711 = getelementptr inbounds nuw i8, ptr %retptr, i64 400
  store ptr %arg.state.0.3.3.4, ptr %retptr.repack2613.repack2663.repack2711, align 8
  %retptr.repack2613.repack2663.repack2713 = getelementptr inbounds nuw i8, ptr %retptr, i64 408
  store i64 %arg.state.0.3.3.5.0, ptr %retptr.repack2613.repack2663.repack2713, align 8
  %retptr.repack2613.repack2663.repack2715 = getelementptr inbounds nuw i8, ptr %retptr, i64 416
  store i64 %arg.state.0.3.3.6.0, ptr %retptr.repack2613.repack2663.repack2715, align 8
  %retptr.repack2613.repack2665 = getelementptr inbounds nuw i8, ptr %retptr, i64 424
  store ptr %arg.state.0.3.4.0, ptr %retptr.repack2613.repack2665, align 8
  %retptr.repack2613.repack2665.repack2717 = getelementptr inbounds nuw i8, ptr %retptr, i64 432
  store ptr %arg.state.0.3.4.1, ptr %retptr.repack2613.repack2665.repack2717, align 8
  %retptr.repack2613.repack2665.repack2719 = getelementptr inbounds nuw i8, ptr %retptr, i64 440
  store i64 %arg.state.0.3.4.2, ptr %retptr.repack2613.repack2665.repack2719, align 8
  %retptr.repack2613.repack2665.repack2721 = getelementptr inbounds nuw i8, ptr %retptr, i64 448
  store i64 %arg.state.0.3.4.3, ptr %retptr.repack2613.repack2665.repack2721, align 8
  %retptr.repack2613.repack2665.repack2723 = getelementptr inbounds nuw i8, ptr %retptr, i64 456
  store ptr %arg.state.0.3.4.4, ptr %retptr.repack2613.repack2665.repack2723, align 8
  %retptr.repack2613.repack2665.repack2725 = getelementptr inbounds nuw i8, ptr %retptr, i64 464
  store i64 %arg.state.0.3.4.5.0, ptr %retptr.repack2613.repack2665.repack2725, align 8
  %retptr.repack2613.repack2665.repack2727 = getelementptr inbounds nuw i8, ptr %retptr, i64 472
  store i64 %arg.state.0.3.4.6.0, ptr %retptr.repack2613.repack2665.repack2727, align 8
  %retptr.repack2613.repack2667 = getelementptr inbounds nuw i8, ptr %retptr, i64 480
  store ptr %arg.state.0.3.5.0, ptr %retptr.repack2613.repack2667, align 8
  %retptr.repack2613.repack2667.repack2729 = getelementptr inbounds nuw i8, ptr %retptr, i64 488
  store ptr %arg.state.0.3.5.1, ptr %retptr.repack2613.repack2667.repack2729, align 8
  %retptr.repack2613.repack2667.repack2731 = getelementptr inbounds nuw i8, ptr %retptr, i64 496
  store i64 %arg.state.0.3.5.2, ptr %retptr.repack2613.repack2667.repack2731, align 8
  %retptr.repack2613.repack2667.repack2733 = getelementptr inbounds nuw i8, ptr %retptr, i64 504
  store i64 %arg.state.0.3.5.3, ptr %retptr.repack2613.repack2667.repack2733, align 8
  %retptr.repack2613.repack2667.repack2735 = getelementptr inbounds nuw i8, ptr %retptr, i64 512
  store ptr %arg.state.0.3.5.4, ptr %retptr.repack2613.repack2667.repack2735, align 8
  %retptr.repack2613.repack2667.repack2737 = getelementptr inbounds nuw i8, ptr %retptr, i64 520
  store i64 %arg.state.0.3.5.5.0, ptr %retptr.repack2613.repack2667.repack2737, align 8
  %retptr.repack2613.repack2667.repack2739 = getelementptr inbounds nuw i8, ptr %retptr, i64 528
  store i64 %arg.state.0.3.5.6.0, ptr %retptr.repack2613.repack2667.repack2739, align 8
  %retptr.repack2603 = getelementptr inbounds nuw i8, ptr %retptr, i64 536
  store ptr %p.2.sroa.0.0.lcssa, ptr %retptr.repack2603, align 8
  %retptr.repack2603.repack2741 = getelementptr inbounds nuw i8, ptr %retptr, i64 544
  store ptr %p.2.sroa.13.0.lcssa, ptr %retptr.repack2603.repack2741, align 8
  %retptr.repack2603.repack2743 = getelementptr inbounds nuw i8, ptr %retptr, i64 552
  store i64 %p.2.sroa.26.0.lcssa, ptr %retptr.repack2603.repack2743, align 8
  %retptr.repack2603.repack2745 = getelementptr inbounds nuw i8, ptr %retptr, i64 560
  store i64 %p.2.sroa.39.0.lcssa, ptr %retptr.repack2603.repack2745, align 8
  %retptr.repack2603.repack2747 = getelementptr inbounds nuw i8, ptr %retptr, i64 568
  store ptr %p.2.sroa.52.0.lcssa, ptr %retptr.repack2603.repack2747, align 8
  %retptr.repack2603.repack2749 = getelementptr inbounds nuw i8, ptr %retptr, i64 576
  store i64 %p.2.sroa.65.0.lcssa, ptr %retptr.repack2603.repack2749, align 8
  %retptr.repack2603.repack2749.repack2753 = getelementptr inbounds nuw i8, ptr %retptr, i64 584
  store i64 %p.2.sroa.78.0.lcssa, ptr %retptr.repack2603.repack2749.repack2753, align 8
  %retptr.repack2603.repack2751 = getelementptr inbounds nuw i8, ptr %retptr, i64 592
  store i64 %p.2.sroa.91.0.lcssa, ptr %retptr.repack2603.repack2751, align 8
  %retptr.repack2603.repack2751.repack2755 = getelementptr inbounds nuw i8, ptr %retptr, i64 600
  store i64 %p.2.sroa.104.0.lcssa, ptr %retptr.repack2603.repack2751.repack2755, align 8
  %retptr.repack2605 = getelementptr inbounds nuw i8, ptr %retptr, i64 608
  store ptr %older.2.sroa.0.0.lcssa, ptr %retptr.repack2605, align 8
  %retptr.repack2605.repack2757 = getelementptr inbounds nuw i8, ptr %retptr, i64 616
  store ptr %older.2.sroa.13.0.lcssa, ptr %retptr.repack2605.repack2757, align 8
  %retptr.repack2605.repack2759 = getelementptr inbounds nuw i8, ptr %retptr, i64 624
  store i64 %older.2.sroa.26.0.lcssa, ptr %retptr.repack2605.repack2759, align 8
  %retptr.repack2605.repack2761 = getelementptr inbounds nuw i8, ptr %retptr, i64 632
  store i64 %older.2.sroa.39.0.lcssa, ptr %retptr.repack2605.repack2761, align 8
  %retptr.repack2605.repack2763 = getelementptr inbounds nuw i8, ptr %retptr, i64 640
  store ptr %older.2.sroa.52.0.lcssa, ptr %retptr.repack2605.repack2763, align 8
  %retptr.repack2605.repack2765 = getelementptr inbounds nuw i8, ptr %retptr, i64 648
  store i64 %older.2.sroa.65.0.lcssa, ptr %retptr.repack2605.repack2765, align 8
  %retptr.repack2605.repack2765.repack2769 = getelementptr inbounds nuw i8, ptr %retptr, i64 656
  store i64 %older.2.sroa.78.0.lcssa, ptr %retptr.repack2605.repack2765.repack2769, align 8
  %retptr.repack2605.repack2767 = getelementptr inbounds nuw i8, ptr %retptr, i64 664
  store i64 %older.2.sroa.91.0.lcssa, ptr %retptr.repack2605.repack2767, align 8
  %retptr.repack2605.repack2767.repack2771 = getelementptr inbounds nuw i8, ptr %retptr, i64 672
  store i64 %older.2.sroa.104.0.lcssa, ptr %retptr.repack2605.repack2767.repack2771, align 8
  %retptr.repack2607 = getelementptr inbounds nuw i8, ptr %retptr, i64 680
  store double %d.2.0.lcssa, ptr %retptr.repack2607, align 8
  %retptr.repack2601 = getelementptr inbounds nuw i8, ptr %retptr, i64 688
  store i64 %passes.2.0.lcssa, ptr %retptr.repack2601, align 8
  tail call void @NRT_decref(ptr %.874.fca.0.0.load)
  tail call void @NRT_decref(ptr %.874.fca.0.0.load)
  tail call void @NRT_decref(ptr %.874.fca.1.0.0.load)
  tail call void @NRT_decref(ptr %.874.fca.1.1.0.load)
  tail call void @NRT_decref(ptr %.874.fca.1.2.0.load)
  tail call void @NRT_decref(ptr %.874.fca.2.0.load)
  tail call void @NRT_decref(ptr %law.3.sroa.0.0.lcssa)
  tail call void @NRT_decref(ptr %law.3.sroa.98.0.lcssa)
  tail call void @NRT_decref(ptr %law.3.sroa.196.0.lcssa)
  tail call void @NRT_decref(ptr %arg.track.0.0)
  br label %common.ret

B1464.endif.endif.if.if:                          ; preds = %B1464.endif.endif
  %.3452 = icmp sgt i32 %.3444, 0
  %.3445 = load ptr, ptr %excinfo.14, align 8
  %.3453 = select i1 %.3452, ptr %.3445, ptr undef
  store ptr %.3453, ptr %excinfo, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #0

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #1

define ptr @_ZN7cpython18elastomer_friction7kernels5scene12march_blocks13follow_blocksB2v1B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqEpgoEBZSIkILKIJAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2934ConstantForce_28float64_20x_201_29274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29478BlockElements_28ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20float64_29x5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29vvvv(ptr readnone captures(none) %py_closure, ptr %py_args, ptr readnone captures(none) %py_kws) local_unnamed_addr {
entry:
  %.5 = alloca ptr, align 8
  %.6 = alloca ptr, align 8
  %.7 = alloca ptr, align 8
  %.8 = alloca ptr, align 8
  %.9 = alloca ptr, align 8
  %.10 = alloca ptr, align 8
  %.11 = alloca ptr, align 8
  %.12 = alloca ptr, align 8
  %.13 = alloca ptr, align 8
  %.14 = alloca ptr, align 8
  %.15 = alloca ptr, align 8
  %.16 = alloca ptr, align 8
  %.17 = alloca ptr, align 8
  %.18 = call i32 (ptr, ptr, i64, i64, ...) @PyArg_UnpackTuple(ptr %py_args, ptr nonnull @.const.follow_blocks, i64 13, i64 13, ptr nonnull %.5, ptr nonnull %.6, ptr nonnull %.7, ptr nonnull %.8, ptr nonnull %.9, ptr nonnull %.10, ptr nonnull %.11, ptr nonnull %.12, ptr nonnull %.13, ptr nonnull %.14, ptr nonnull %.15, ptr nonnull %.16, ptr nonnull %.17)
  %.19 = icmp eq i32 %.18, 0
  %.53 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  %.73 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.53, i8 0, i64 56, i1 false)
  %.151 = alloca { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.73, i8 0, i64 56, i1 false)
  %.171 = alloca { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.151, i8 0, i64 72, i1 false)
  %.191 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.171, i8 0, i64 72, i1 false)
  %.211 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.191, i8 0, i64 56, i1 false)
  %.231 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.211, i8 0, i64 56, i1 false)
  %.251 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.231, i8 0, i64 56, i1 false)
  %.271 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.251, i8 0, i64 56, i1 false)
  %.355 = alloca { ptr, ptr, i64, i64, ptr, [3 x i64], [3 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.271, i8 0, i64 56, i1 false)
  %.375 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(88) %.355, i8 0, i64 88, i1 false)
  %.395 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.375, i8 0, i64 56, i1 false)
  %.428 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.395, i8 0, i64 56, i1 false)
  %.448 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.428, i8 0, i64 56, i1 false)
  %.468 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.448, i8 0, i64 56, i1 false)
  %.488 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.468, i8 0, i64 56, i1 false)
  %.508 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.488, i8 0, i64 56, i1 false)
  %.528 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.508, i8 0, i64 56, i1 false)
  %.570 = alloca { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.528, i8 0, i64 56, i1 false)
  %.590 = alloca { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.570, i8 0, i64 72, i1 false)
  %.686 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.590, i8 0, i64 72, i1 false)
  %.709 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.686, i8 0, i64 56, i1 false)
  %.732 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.709, i8 0, i64 56, i1 false)
  %.768 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.732, i8 0, i64 56, i1 false)
  %.788 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.768, i8 0, i64 56, i1 false)
  %.808 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.788, i8 0, i64 56, i1 false)
  %.828 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.808, i8 0, i64 56, i1 false)
  %.848 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.828, i8 0, i64 56, i1 false)
  %.868 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.848, i8 0, i64 56, i1 false)
  %.888 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.868, i8 0, i64 56, i1 false)
  %.908 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.888, i8 0, i64 56, i1 false)
  %.990 = alloca { { { { ptr, ptr, i64, i64, ptr, [3 x i64], [3 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } } }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, double }, i64 }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.908, i8 0, i64 56, i1 false)
  %excinfo = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(696) %.990, i8 0, i64 696, i1 false)
  store ptr null, ptr %excinfo, align 8
  %.1404 = alloca { ptr, ptr, i64, i64, ptr, [3 x i64], [3 x i64] }, align 8
  %.1442 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(88) %.1404, i8 0, i64 88, i1 false)
  %.1476 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1442, i8 0, i64 56, i1 false)
  %.1519 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1476, i8 0, i64 56, i1 false)
  %.1553 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1519, i8 0, i64 56, i1 false)
  %.1587 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1553, i8 0, i64 56, i1 false)
  %.1621 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1587, i8 0, i64 56, i1 false)
  %.1655 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1621, i8 0, i64 56, i1 false)
  %.1689 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1655, i8 0, i64 56, i1 false)
  %.1731 = alloca { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1689, i8 0, i64 56, i1 false)
  %.1767 = alloca { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.1731, i8 0, i64 72, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.1767, i8 0, i64 72, i1 false)
  br i1 %.19, label %common.ret, label %entry.endif, !prof !11

common.ret:                                       ; preds = %entry.endif.endif.endif.endif.endif.endif.endif, %entry.endif.endif.endif.e...endif.23, %entry.endif.endif.endif.e...endif.23.if, %entry.endif.endif.endif.e...endif.23.endif.endif, %entry.endif.endif.endif.e...if.23.endif.if, %entry.endif.endif.endif.e...if.23.endif, %arg0.err, %entry, %entry.endif.endif.endif.e...if.23.if.if, %entry.endif.endif.endif.e...endif.22.endif.endif.endif, %entry.endif.if
  %common.ret.op = phi ptr [ null, %entry.endif.endif.endif.e...if.23.if.if ], [ null, %entry ], [ null, %entry.endif.if ], [ null, %entry.endif.endif.endif.e...endif.23.if ], [ %.1360, %entry.endif.endif.endif.e...endif.22.endif.endif.endif ], [ null, %arg0.err ], [ null, %entry.endif.endif.endif.endif.endif.endif.endif ], [ null, %entry.endif.endif.endif.e...endif.23 ], [ null, %entry.endif.endif.endif.e...if.23.endif ], [ null, %entry.endif.endif.endif.e...if.23.endif.if ], [ null, %entry.endif.endif.endif.e...endif.23.endif.endif ]
  ret ptr %common.ret.op

entry.endif:                                      ; preds = %entry
  %.23 = load ptr, ptr @_ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks13follow_blocksB2v1B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqEpgoEBZSIkILKIJAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2934ConstantForce_28float64_20x_201_29274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29478BlockElements_28ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20float64_29x5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29vvvv, align 8
  %.26 = icmp eq ptr %.23, null
  br i1 %.26, label %entry.endif.if, label %entry.endif.endif, !prof !11

entry.endif.if:                                   ; preds = %entry.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.missing Environment: _ZN08NumbaEnv18elastomer_friction7kernels5scene12march_blocks13follow_blocksB2v1B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqEpgoEBZSIkILKIJAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2934ConstantForce_28float64_20x_201_29274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29478BlockElements_28ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20float64_29x5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29vvvv")
  br label %common.ret

entry.endif.endif:                                ; preds = %entry.endif
  %.30 = load ptr, ptr %.5, align 8
  %.36 = call i64 @PyTuple_Size(ptr %.30)
  %.37.not = icmp ne i64 %.36, 3
  br i1 %.37.not, label %entry.endif.endif.if, label %entry.endif.endif.endif, !prof !11

entry.endif.endif.if:                             ; preds = %entry.endif.endif
  call void (ptr, ptr, ...) @PyErr_Format(ptr nonnull @PyExc_ValueError, ptr nonnull @".const.size mismatch for tuple, expected 3 element(s) but got %zd", i64 %.36)
  br label %entry.endif.endif.endif

entry.endif.endif.endif:                          ; preds = %entry.endif.endif.if, %entry.endif.endif
  %.43 = call ptr @PyTuple_GetItem(ptr %.30, i64 0)
  %.44 = call ptr @PyNumber_Float(ptr %.43)
  %.45 = call double @PyFloat_AsDouble(ptr %.44)
  call void @Py_DecRef(ptr %.44)
  %.47 = call ptr @PyErr_Occurred()
  %.48.not = icmp eq ptr %.47, null
  br i1 %.48.not, label %entry.endif.endif.endif.endif, label %entry.endif.endif.endif.if, !prof !12

entry.endif.endif.endif.if:                       ; preds = %entry.endif.endif.endif
  br label %entry.endif.endif.endif.endif

entry.endif.endif.endif.endif:                    ; preds = %entry.endif.endif.endif.if, %entry.endif.endif.endif
  %.31.1 = phi i1 [ true, %entry.endif.endif.endif.if ], [ %.37.not, %entry.endif.endif.endif ]
  %.52 = call ptr @PyTuple_GetItem(ptr %.30, i64 1)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.53, i8 0, i64 56, i1 false)
  %.57 = call i32 @NRT_adapt_ndarray_from_python(ptr %.52, ptr nonnull %.53)
  %sunkaddr = getelementptr inbounds i8, ptr %.53, i64 24
  %.61 = load i64, ptr %sunkaddr, align 8
  %.62 = icmp ne i64 %.61, 8
  %.63 = icmp ne i32 %.57, 0
  %.64 = or i1 %.63, %.62
  br i1 %.64, label %entry.endif.endif.endif.endif.endif.if, label %entry.endif.endif.endif.endif.endif.endif, !prof !11

entry.endif.endif.endif.endif.endif.if:           ; preds = %entry.endif.endif.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.endif.endif.endif

entry.endif.endif.endif.endif.endif.endif:        ; preds = %entry.endif.endif.endif.endif, %entry.endif.endif.endif.endif.endif.if
  %.31.2 = phi i1 [ true, %entry.endif.endif.endif.endif.endif.if ], [ %.31.1, %entry.endif.endif.endif.endif ]
  %.68.fca.0.load = load ptr, ptr %.53, align 8
  %sunkaddr1 = getelementptr inbounds i8, ptr %.53, i64 8
  %.68.fca.1.load = load ptr, ptr %sunkaddr1, align 8
  %sunkaddr2 = getelementptr inbounds i8, ptr %.53, i64 16
  %.68.fca.2.load = load i64, ptr %sunkaddr2, align 8
  %sunkaddr3 = getelementptr inbounds i8, ptr %.53, i64 32
  %.68.fca.4.load = load ptr, ptr %sunkaddr3, align 8
  %sunkaddr4 = getelementptr inbounds i8, ptr %.53, i64 40
  %.68.fca.5.0.load = load i64, ptr %sunkaddr4, align 8
  %sunkaddr5 = getelementptr inbounds i8, ptr %.53, i64 48
  %.68.fca.6.0.load = load i64, ptr %sunkaddr5, align 8
  %.72 = call ptr @PyTuple_GetItem(ptr %.30, i64 2)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.73, i8 0, i64 56, i1 false)
  %.77 = call i32 @NRT_adapt_ndarray_from_python(ptr %.72, ptr nonnull %.73)
  %sunkaddr6 = getelementptr inbounds i8, ptr %.73, i64 24
  %.81 = load i64, ptr %sunkaddr6, align 8
  %.82 = icmp ne i64 %.81, 8
  %.83 = icmp ne i32 %.77, 0
  %.84 = or i1 %.83, %.82
  br i1 %.84, label %entry.endif.endif.endif.endif.endif.endif.if, label %entry.endif.endif.endif.endif.endif.endif.endif, !prof !11

entry.endif.endif.endif.endif.endif.endif.if:     ; preds = %entry.endif.endif.endif.endif.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.endif.endif.endif.endif

entry.endif.endif.endif.endif.endif.endif.endif:  ; preds = %entry.endif.endif.endif.endif.endif.endif.if, %entry.endif.endif.endif.endif.endif.endif
  %.88.fca.0.load = load ptr, ptr %.73, align 8
  %sunkaddr7 = getelementptr inbounds i8, ptr %.73, i64 8
  %.88.fca.1.load = load ptr, ptr %sunkaddr7, align 8
  %sunkaddr8 = getelementptr inbounds i8, ptr %.73, i64 16
  %.88.fca.2.load = load i64, ptr %sunkaddr8, align 8
  %sunkaddr9 = getelementptr inbounds i8, ptr %.73, i64 32
  %.88.fca.4.load = load ptr, ptr %sunkaddr9, align 8
  %sunkaddr10 = getelementptr inbounds i8, ptr %.73, i64 40
  %.88.fca.5.0.load = load i64, ptr %sunkaddr10, align 8
  %sunkaddr11 = getelementptr inbounds i8, ptr %.73, i64 48
  %.88.fca.6.0.load = load i64, ptr %sunkaddr11, align 8
  %brmerge1222 = or i1 %.31.2, %.84
  br i1 %brmerge1222, label %common.ret, label %entry.endif.endif.endif.e...endif, !prof !13

entry.endif.endif.endif.e...endif:                ; preds = %entry.endif.endif.endif.endif.endif.endif.endif
  %.107 = load ptr, ptr %.6, align 8
  %.113 = call i64 @PyTuple_Size(ptr %.107)
  %.114.not.not = icmp ne i64 %.113, 1
  br i1 %.114.not.not, label %entry.endif.endif.endif.e...endif.if, label %entry.endif.endif.endif.e...endif.endif, !prof !11

arg0.err:                                         ; preds = %entry.endif.endif.endif.e...endif.4.endif, %entry.endif.endif.endif.e...endif.endif, %arg2.err
  call void @NRT_decref(ptr %.68.fca.0.load)
  call void @NRT_decref(ptr %.88.fca.0.load)
  br label %common.ret

entry.endif.endif.endif.e...endif.if:             ; preds = %entry.endif.endif.endif.e...endif
  call void (ptr, ptr, ...) @PyErr_Format(ptr nonnull @PyExc_ValueError, ptr nonnull @".const.size mismatch for tuple, expected 1 element(s) but got %zd", i64 %.113)
  br label %entry.endif.endif.endif.e...endif.endif

entry.endif.endif.endif.e...endif.endif:          ; preds = %entry.endif.endif.endif.e...endif.if, %entry.endif.endif.endif.e...endif
  %0 = icmp ne i64 %.113, 1
  %.120 = call ptr @PyTuple_GetItem(ptr %.107, i64 0)
  %.121 = call ptr @PyNumber_Float(ptr %.120)
  %.122 = call double @PyFloat_AsDouble(ptr %.121)
  call void @Py_DecRef(ptr %.121)
  %.124 = call ptr @PyErr_Occurred()
  %.125.not = icmp ne ptr %.124, null
  %brmerge = or i1 %0, %.125.not
  br i1 %brmerge, label %arg0.err, label %entry.endif.endif.endif.e...endif.endif.endif.endif, !prof !14

entry.endif.endif.endif.e...endif.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.endif
  %.137 = load ptr, ptr %.7, align 8
  %.143 = call i64 @PyTuple_Size(ptr %.137)
  %.144.not = icmp ne i64 %.143, 7
  br i1 %.144.not, label %entry.endif.endif.endif.e...if.1, label %entry.endif.endif.endif.e...endif.1, !prof !11

entry.endif.endif.endif.e...if.1:                 ; preds = %entry.endif.endif.endif.e...endif.endif.endif.endif
  call void (ptr, ptr, ...) @PyErr_Format(ptr nonnull @PyExc_ValueError, ptr nonnull @".const.size mismatch for tuple, expected 7 element(s) but got %zd", i64 %.143)
  br label %entry.endif.endif.endif.e...endif.1

entry.endif.endif.endif.e...endif.1:              ; preds = %entry.endif.endif.endif.e...if.1, %entry.endif.endif.endif.e...endif.endif.endif.endif
  %.150 = call ptr @PyTuple_GetItem(ptr %.137, i64 0)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.151, i8 0, i64 72, i1 false)
  %.155 = call i32 @NRT_adapt_ndarray_from_python(ptr %.150, ptr nonnull %.151)
  %sunkaddr12 = getelementptr inbounds i8, ptr %.151, i64 24
  %.159 = load i64, ptr %sunkaddr12, align 8
  %.160 = icmp ne i64 %.159, 8
  %.161 = icmp ne i32 %.155, 0
  %.162 = or i1 %.161, %.160
  br i1 %.162, label %entry.endif.endif.endif.e...endif.1.if, label %entry.endif.endif.endif.e...endif.1.endif, !prof !11

entry.endif.endif.endif.e...endif.1.if:           ; preds = %entry.endif.endif.endif.e...endif.1
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.1.endif

entry.endif.endif.endif.e...endif.1.endif:        ; preds = %entry.endif.endif.endif.e...endif.1.if, %entry.endif.endif.endif.e...endif.1
  %.166.fca.0.load = load ptr, ptr %.151, align 8
  %sunkaddr13 = getelementptr inbounds i8, ptr %.151, i64 8
  %.166.fca.1.load = load ptr, ptr %sunkaddr13, align 8
  %sunkaddr14 = getelementptr inbounds i8, ptr %.151, i64 16
  %.166.fca.2.load = load i64, ptr %sunkaddr14, align 8
  %sunkaddr15 = getelementptr inbounds i8, ptr %.151, i64 32
  %.166.fca.4.load = load ptr, ptr %sunkaddr15, align 8
  %sunkaddr16 = getelementptr inbounds i8, ptr %.151, i64 40
  %.166.fca.5.0.load = load i64, ptr %sunkaddr16, align 8
  %sunkaddr17 = getelementptr inbounds i8, ptr %.151, i64 48
  %.166.fca.5.1.load = load i64, ptr %sunkaddr17, align 8
  %sunkaddr18 = getelementptr inbounds i8, ptr %.151, i64 56
  %.166.fca.6.0.load = load i64, ptr %sunkaddr18, align 8
  %sunkaddr19 = getelementptr inbounds i8, ptr %.151, i64 64
  %.166.fca.6.1.load = load i64, ptr %sunkaddr19, align 8
  br i1 %.162, label %entry.endif.endif.endif.e...endif.1.endif.if, label %entry.endif.endif.endif.e...endif.1.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.1.endif.if:     ; preds = %entry.endif.endif.endif.e...endif.1.endif
  br label %entry.endif.endif.endif.e...endif.1.endif.endif

entry.endif.endif.endif.e...endif.1.endif.endif:  ; preds = %entry.endif.endif.endif.e...endif.1.endif.if, %entry.endif.endif.endif.e...endif.1.endif
  %.138.1 = phi i1 [ true, %entry.endif.endif.endif.e...endif.1.endif.if ], [ %.144.not, %entry.endif.endif.endif.e...endif.1.endif ]
  %.170 = call ptr @PyTuple_GetItem(ptr %.137, i64 1)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.171, i8 0, i64 72, i1 false)
  %.175 = call i32 @NRT_adapt_ndarray_from_python(ptr %.170, ptr nonnull %.171)
  %sunkaddr20 = getelementptr inbounds i8, ptr %.171, i64 24
  %.179 = load i64, ptr %sunkaddr20, align 8
  %.180 = icmp ne i64 %.179, 8
  %.181 = icmp ne i32 %.175, 0
  %.182 = or i1 %.181, %.180
  br i1 %.182, label %entry.endif.endif.endif.e...endif.1.endif.endif.if, label %entry.endif.endif.endif.e...endif.1.endif.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.1.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.1.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.1.endif.endif.endif

entry.endif.endif.endif.e...endif.1.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.1.endif.endif.if, %entry.endif.endif.endif.e...endif.1.endif.endif
  %.186.fca.0.load = load ptr, ptr %.171, align 8
  %sunkaddr21 = getelementptr inbounds i8, ptr %.171, i64 8
  %.186.fca.1.load = load ptr, ptr %sunkaddr21, align 8
  %sunkaddr22 = getelementptr inbounds i8, ptr %.171, i64 16
  %.186.fca.2.load = load i64, ptr %sunkaddr22, align 8
  %sunkaddr23 = getelementptr inbounds i8, ptr %.171, i64 32
  %.186.fca.4.load = load ptr, ptr %sunkaddr23, align 8
  %sunkaddr24 = getelementptr inbounds i8, ptr %.171, i64 40
  %.186.fca.5.0.load = load i64, ptr %sunkaddr24, align 8
  %sunkaddr25 = getelementptr inbounds i8, ptr %.171, i64 48
  %.186.fca.5.1.load = load i64, ptr %sunkaddr25, align 8
  %sunkaddr26 = getelementptr inbounds i8, ptr %.171, i64 56
  %.186.fca.6.0.load = load i64, ptr %sunkaddr26, align 8
  %sunkaddr27 = getelementptr inbounds i8, ptr %.171, i64 64
  %.186.fca.6.1.load = load i64, ptr %sunkaddr27, align 8
  br i1 %.182, label %entry.endif.endif.endif.e...if.2, label %entry.endif.endif.endif.e...endif.2, !prof !11

entry.endif.endif.endif.e...if.2:                 ; preds = %entry.endif.endif.endif.e...endif.1.endif.endif.endif
  br label %entry.endif.endif.endif.e...endif.2

entry.endif.endif.endif.e...endif.2:              ; preds = %entry.endif.endif.endif.e...if.2, %entry.endif.endif.endif.e...endif.1.endif.endif.endif
  %.138.2 = phi i1 [ true, %entry.endif.endif.endif.e...if.2 ], [ %.138.1, %entry.endif.endif.endif.e...endif.1.endif.endif.endif ]
  %.190 = call ptr @PyTuple_GetItem(ptr %.137, i64 2)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.191, i8 0, i64 56, i1 false)
  %.195 = call i32 @NRT_adapt_ndarray_from_python(ptr %.190, ptr nonnull %.191)
  %sunkaddr28 = getelementptr inbounds i8, ptr %.191, i64 24
  %.199 = load i64, ptr %sunkaddr28, align 8
  %.200 = icmp ne i64 %.199, 8
  %.201 = icmp ne i32 %.195, 0
  %.202 = or i1 %.201, %.200
  br i1 %.202, label %entry.endif.endif.endif.e...endif.2.endif.if, label %entry.endif.endif.endif.e...endif.2.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.2.endif.if:     ; preds = %entry.endif.endif.endif.e...endif.2
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.2.endif.endif

entry.endif.endif.endif.e...endif.2.endif.endif:  ; preds = %entry.endif.endif.endif.e...endif.2, %entry.endif.endif.endif.e...endif.2.endif.if
  %.138.3 = phi i1 [ true, %entry.endif.endif.endif.e...endif.2.endif.if ], [ %.138.2, %entry.endif.endif.endif.e...endif.2 ]
  %.206.fca.0.load = load ptr, ptr %.191, align 8
  %sunkaddr29 = getelementptr inbounds i8, ptr %.191, i64 8
  %.206.fca.1.load = load ptr, ptr %sunkaddr29, align 8
  %sunkaddr30 = getelementptr inbounds i8, ptr %.191, i64 16
  %.206.fca.2.load = load i64, ptr %sunkaddr30, align 8
  %sunkaddr31 = getelementptr inbounds i8, ptr %.191, i64 32
  %.206.fca.4.load = load ptr, ptr %sunkaddr31, align 8
  %sunkaddr32 = getelementptr inbounds i8, ptr %.191, i64 40
  %.206.fca.5.0.load = load i64, ptr %sunkaddr32, align 8
  %sunkaddr33 = getelementptr inbounds i8, ptr %.191, i64 48
  %.206.fca.6.0.load = load i64, ptr %sunkaddr33, align 8
  %.210 = call ptr @PyTuple_GetItem(ptr %.137, i64 3)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.211, i8 0, i64 56, i1 false)
  %.215 = call i32 @NRT_adapt_ndarray_from_python(ptr %.210, ptr nonnull %.211)
  %sunkaddr34 = getelementptr inbounds i8, ptr %.211, i64 24
  %.219 = load i64, ptr %sunkaddr34, align 8
  %.220 = icmp ne i64 %.219, 8
  %.221 = icmp ne i32 %.215, 0
  %.222 = or i1 %.221, %.220
  br i1 %.222, label %entry.endif.endif.endif.e...if.3, label %entry.endif.endif.endif.e...endif.3, !prof !11

entry.endif.endif.endif.e...if.3:                 ; preds = %entry.endif.endif.endif.e...endif.2.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.3

entry.endif.endif.endif.e...endif.3:              ; preds = %entry.endif.endif.endif.e...endif.2.endif.endif, %entry.endif.endif.endif.e...if.3
  %.138.4 = phi i1 [ true, %entry.endif.endif.endif.e...if.3 ], [ %.138.3, %entry.endif.endif.endif.e...endif.2.endif.endif ]
  %.226.fca.0.load = load ptr, ptr %.211, align 8
  %sunkaddr35 = getelementptr inbounds i8, ptr %.211, i64 8
  %.226.fca.1.load = load ptr, ptr %sunkaddr35, align 8
  %sunkaddr36 = getelementptr inbounds i8, ptr %.211, i64 16
  %.226.fca.2.load = load i64, ptr %sunkaddr36, align 8
  %sunkaddr37 = getelementptr inbounds i8, ptr %.211, i64 32
  %.226.fca.4.load = load ptr, ptr %sunkaddr37, align 8
  %sunkaddr38 = getelementptr inbounds i8, ptr %.211, i64 40
  %.226.fca.5.0.load = load i64, ptr %sunkaddr38, align 8
  %sunkaddr39 = getelementptr inbounds i8, ptr %.211, i64 48
  %.226.fca.6.0.load = load i64, ptr %sunkaddr39, align 8
  %.230 = call ptr @PyTuple_GetItem(ptr %.137, i64 4)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.231, i8 0, i64 56, i1 false)
  %.235 = call i32 @NRT_adapt_ndarray_from_python(ptr %.230, ptr nonnull %.231)
  %sunkaddr40 = getelementptr inbounds i8, ptr %.231, i64 24
  %.239 = load i64, ptr %sunkaddr40, align 8
  %.240 = icmp ne i64 %.239, 8
  %.241 = icmp ne i32 %.235, 0
  %.242 = or i1 %.241, %.240
  br i1 %.242, label %entry.endif.endif.endif.e...endif.3.endif.if, label %entry.endif.endif.endif.e...endif.3.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.3.endif.if:     ; preds = %entry.endif.endif.endif.e...endif.3
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.3.endif.endif

entry.endif.endif.endif.e...endif.3.endif.endif:  ; preds = %entry.endif.endif.endif.e...endif.3, %entry.endif.endif.endif.e...endif.3.endif.if
  %.138.5 = phi i1 [ true, %entry.endif.endif.endif.e...endif.3.endif.if ], [ %.138.4, %entry.endif.endif.endif.e...endif.3 ]
  %.246.fca.0.load = load ptr, ptr %.231, align 8
  %sunkaddr41 = getelementptr inbounds i8, ptr %.231, i64 8
  %.246.fca.1.load = load ptr, ptr %sunkaddr41, align 8
  %sunkaddr42 = getelementptr inbounds i8, ptr %.231, i64 16
  %.246.fca.2.load = load i64, ptr %sunkaddr42, align 8
  %sunkaddr43 = getelementptr inbounds i8, ptr %.231, i64 32
  %.246.fca.4.load = load ptr, ptr %sunkaddr43, align 8
  %sunkaddr44 = getelementptr inbounds i8, ptr %.231, i64 40
  %.246.fca.5.0.load = load i64, ptr %sunkaddr44, align 8
  %sunkaddr45 = getelementptr inbounds i8, ptr %.231, i64 48
  %.246.fca.6.0.load = load i64, ptr %sunkaddr45, align 8
  %.250 = call ptr @PyTuple_GetItem(ptr %.137, i64 5)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.251, i8 0, i64 56, i1 false)
  %.255 = call i32 @NRT_adapt_ndarray_from_python(ptr %.250, ptr nonnull %.251)
  %sunkaddr46 = getelementptr inbounds i8, ptr %.251, i64 24
  %.259 = load i64, ptr %sunkaddr46, align 8
  %.260 = icmp ne i64 %.259, 8
  %.261 = icmp ne i32 %.255, 0
  %.262 = or i1 %.261, %.260
  br i1 %.262, label %entry.endif.endif.endif.e...if.4, label %entry.endif.endif.endif.e...endif.4, !prof !11

entry.endif.endif.endif.e...if.4:                 ; preds = %entry.endif.endif.endif.e...endif.3.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.4

entry.endif.endif.endif.e...endif.4:              ; preds = %entry.endif.endif.endif.e...endif.3.endif.endif, %entry.endif.endif.endif.e...if.4
  %.138.6 = phi i1 [ true, %entry.endif.endif.endif.e...if.4 ], [ %.138.5, %entry.endif.endif.endif.e...endif.3.endif.endif ]
  %.266.fca.0.load = load ptr, ptr %.251, align 8
  %sunkaddr47 = getelementptr inbounds i8, ptr %.251, i64 8
  %.266.fca.1.load = load ptr, ptr %sunkaddr47, align 8
  %sunkaddr48 = getelementptr inbounds i8, ptr %.251, i64 16
  %.266.fca.2.load = load i64, ptr %sunkaddr48, align 8
  %sunkaddr49 = getelementptr inbounds i8, ptr %.251, i64 32
  %.266.fca.4.load = load ptr, ptr %sunkaddr49, align 8
  %sunkaddr50 = getelementptr inbounds i8, ptr %.251, i64 40
  %.266.fca.5.0.load = load i64, ptr %sunkaddr50, align 8
  %sunkaddr51 = getelementptr inbounds i8, ptr %.251, i64 48
  %.266.fca.6.0.load = load i64, ptr %sunkaddr51, align 8
  %.270 = call ptr @PyTuple_GetItem(ptr %.137, i64 6)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.271, i8 0, i64 56, i1 false)
  %.275 = call i32 @NRT_adapt_ndarray_from_python(ptr %.270, ptr nonnull %.271)
  %sunkaddr52 = getelementptr inbounds i8, ptr %.271, i64 24
  %.279 = load i64, ptr %sunkaddr52, align 8
  %.280 = icmp ne i64 %.279, 8
  %.281 = icmp ne i32 %.275, 0
  %.282 = or i1 %.281, %.280
  br i1 %.282, label %entry.endif.endif.endif.e...endif.4.if, label %entry.endif.endif.endif.e...endif.4.endif, !prof !11

entry.endif.endif.endif.e...endif.4.if:           ; preds = %entry.endif.endif.endif.e...endif.4
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.4.endif

entry.endif.endif.endif.e...endif.4.endif:        ; preds = %entry.endif.endif.endif.e...endif.4.if, %entry.endif.endif.endif.e...endif.4
  %.286.fca.0.load = load ptr, ptr %.271, align 8
  %sunkaddr53 = getelementptr inbounds i8, ptr %.271, i64 8
  %.286.fca.1.load = load ptr, ptr %sunkaddr53, align 8
  %sunkaddr54 = getelementptr inbounds i8, ptr %.271, i64 16
  %.286.fca.2.load = load i64, ptr %sunkaddr54, align 8
  %sunkaddr55 = getelementptr inbounds i8, ptr %.271, i64 32
  %.286.fca.4.load = load ptr, ptr %sunkaddr55, align 8
  %sunkaddr56 = getelementptr inbounds i8, ptr %.271, i64 40
  %.286.fca.5.0.load = load i64, ptr %sunkaddr56, align 8
  %sunkaddr57 = getelementptr inbounds i8, ptr %.271, i64 48
  %.286.fca.6.0.load = load i64, ptr %sunkaddr57, align 8
  %brmerge1217 = or i1 %.138.6, %.282
  br i1 %brmerge1217, label %arg0.err, label %entry.endif.endif.endif.e...endif.4.endif.endif.endif, !prof !13

entry.endif.endif.endif.e...endif.4.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.4.endif
  %.328 = load ptr, ptr %.8, align 8
  %.334 = call i64 @PyTuple_Size(ptr %.328)
  %.335.not = icmp ne i64 %.334, 4
  br i1 %.335.not, label %entry.endif.endif.endif.e...if.5, label %entry.endif.endif.endif.e...endif.5, !prof !11

arg2.err:                                         ; preds = %entry.endif.endif.endif.e...endif.11.endif.endif, %arg3.err
  call void @NRT_decref(ptr %.166.fca.0.load)
  call void @NRT_decref(ptr %.186.fca.0.load)
  call void @NRT_decref(ptr %.206.fca.0.load)
  call void @NRT_decref(ptr %.226.fca.0.load)
  call void @NRT_decref(ptr %.246.fca.0.load)
  call void @NRT_decref(ptr %.266.fca.0.load)
  call void @NRT_decref(ptr %.286.fca.0.load)
  br label %arg0.err

entry.endif.endif.endif.e...if.5:                 ; preds = %entry.endif.endif.endif.e...endif.4.endif.endif.endif
  call void (ptr, ptr, ...) @PyErr_Format(ptr nonnull @PyExc_ValueError, ptr nonnull @".const.size mismatch for tuple, expected 4 element(s) but got %zd", i64 %.334)
  br label %entry.endif.endif.endif.e...endif.5

entry.endif.endif.endif.e...endif.5:              ; preds = %entry.endif.endif.endif.e...if.5, %entry.endif.endif.endif.e...endif.4.endif.endif.endif
  %.341 = call ptr @PyTuple_GetItem(ptr %.328, i64 0)
  %.347 = call i64 @PyTuple_Size(ptr %.341)
  %.348.not = icmp ne i64 %.347, 4
  br i1 %.348.not, label %entry.endif.endif.endif.e...endif.5.if, label %entry.endif.endif.endif.e...endif.5.endif, !prof !11

entry.endif.endif.endif.e...endif.5.if:           ; preds = %entry.endif.endif.endif.e...endif.5
  call void (ptr, ptr, ...) @PyErr_Format(ptr nonnull @PyExc_ValueError, ptr nonnull @".const.size mismatch for tuple, expected 4 element(s) but got %zd", i64 %.347)
  br label %entry.endif.endif.endif.e...endif.5.endif

entry.endif.endif.endif.e...endif.5.endif:        ; preds = %entry.endif.endif.endif.e...endif.5.if, %entry.endif.endif.endif.e...endif.5
  %.354 = call ptr @PyTuple_GetItem(ptr %.341, i64 0)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(88) %.355, i8 0, i64 88, i1 false)
  %.359 = call i32 @NRT_adapt_ndarray_from_python(ptr %.354, ptr nonnull %.355)
  %sunkaddr58 = getelementptr inbounds i8, ptr %.355, i64 24
  %.363 = load i64, ptr %sunkaddr58, align 8
  %.364 = icmp ne i64 %.363, 8
  %.365 = icmp ne i32 %.359, 0
  %.366 = or i1 %.365, %.364
  br i1 %.366, label %entry.endif.endif.endif.e...endif.5.endif.if, label %entry.endif.endif.endif.e...endif.5.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.5.endif.if:     ; preds = %entry.endif.endif.endif.e...endif.5.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.5.endif.endif

entry.endif.endif.endif.e...endif.5.endif.endif:  ; preds = %entry.endif.endif.endif.e...endif.5.endif.if, %entry.endif.endif.endif.e...endif.5.endif
  %.370.fca.0.load = load ptr, ptr %.355, align 8
  %sunkaddr59 = getelementptr inbounds i8, ptr %.355, i64 8
  %.370.fca.1.load = load ptr, ptr %sunkaddr59, align 8
  %sunkaddr60 = getelementptr inbounds i8, ptr %.355, i64 16
  %.370.fca.2.load = load i64, ptr %sunkaddr60, align 8
  %sunkaddr61 = getelementptr inbounds i8, ptr %.355, i64 32
  %.370.fca.4.load = load ptr, ptr %sunkaddr61, align 8
  %sunkaddr62 = getelementptr inbounds i8, ptr %.355, i64 40
  %.370.fca.5.0.load = load i64, ptr %sunkaddr62, align 8
  %sunkaddr63 = getelementptr inbounds i8, ptr %.355, i64 48
  %.370.fca.5.1.load = load i64, ptr %sunkaddr63, align 8
  %sunkaddr64 = getelementptr inbounds i8, ptr %.355, i64 56
  %.370.fca.5.2.load = load i64, ptr %sunkaddr64, align 8
  %sunkaddr65 = getelementptr inbounds i8, ptr %.355, i64 64
  %.370.fca.6.0.load = load i64, ptr %sunkaddr65, align 8
  %sunkaddr66 = getelementptr inbounds i8, ptr %.355, i64 72
  %.370.fca.6.1.load = load i64, ptr %sunkaddr66, align 8
  %sunkaddr67 = getelementptr inbounds i8, ptr %.355, i64 80
  %.370.fca.6.2.load = load i64, ptr %sunkaddr67, align 8
  br i1 %.366, label %entry.endif.endif.endif.e...endif.5.endif.endif.if, label %entry.endif.endif.endif.e...endif.5.endif.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.5.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.5.endif.endif
  br label %entry.endif.endif.endif.e...endif.5.endif.endif.endif

entry.endif.endif.endif.e...endif.5.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.5.endif.endif.if, %entry.endif.endif.endif.e...endif.5.endif.endif
  %.342.1 = phi i1 [ true, %entry.endif.endif.endif.e...endif.5.endif.endif.if ], [ %.348.not, %entry.endif.endif.endif.e...endif.5.endif.endif ]
  %.374 = call ptr @PyTuple_GetItem(ptr %.341, i64 1)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.375, i8 0, i64 56, i1 false)
  %.379 = call i32 @NRT_adapt_ndarray_from_python(ptr %.374, ptr nonnull %.375)
  %sunkaddr68 = getelementptr inbounds i8, ptr %.375, i64 24
  %.383 = load i64, ptr %sunkaddr68, align 8
  %.384 = icmp ne i64 %.383, 8
  %.385 = icmp ne i32 %.379, 0
  %.386 = or i1 %.385, %.384
  br i1 %.386, label %entry.endif.endif.endif.e...endif.6.if, label %entry.endif.endif.endif.e...endif.6.endif, !prof !11

entry.endif.endif.endif.e...endif.6.if:           ; preds = %entry.endif.endif.endif.e...endif.5.endif.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.6.endif

entry.endif.endif.endif.e...endif.6.endif:        ; preds = %entry.endif.endif.endif.e...endif.5.endif.endif.endif, %entry.endif.endif.endif.e...endif.6.if
  %.342.2 = phi i1 [ true, %entry.endif.endif.endif.e...endif.6.if ], [ %.342.1, %entry.endif.endif.endif.e...endif.5.endif.endif.endif ]
  %.390.fca.0.load = load ptr, ptr %.375, align 8
  %sunkaddr69 = getelementptr inbounds i8, ptr %.375, i64 8
  %.390.fca.1.load = load ptr, ptr %sunkaddr69, align 8
  %sunkaddr70 = getelementptr inbounds i8, ptr %.375, i64 16
  %.390.fca.2.load = load i64, ptr %sunkaddr70, align 8
  %sunkaddr71 = getelementptr inbounds i8, ptr %.375, i64 32
  %.390.fca.4.load = load ptr, ptr %sunkaddr71, align 8
  %sunkaddr72 = getelementptr inbounds i8, ptr %.375, i64 40
  %.390.fca.5.0.load = load i64, ptr %sunkaddr72, align 8
  %sunkaddr73 = getelementptr inbounds i8, ptr %.375, i64 48
  %.390.fca.6.0.load = load i64, ptr %sunkaddr73, align 8
  %.394 = call ptr @PyTuple_GetItem(ptr %.341, i64 2)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.395, i8 0, i64 56, i1 false)
  %.399 = call i32 @NRT_adapt_ndarray_from_python(ptr %.394, ptr nonnull %.395)
  %sunkaddr74 = getelementptr inbounds i8, ptr %.395, i64 24
  %.403 = load i64, ptr %sunkaddr74, align 8
  %.404 = icmp ne i64 %.403, 8
  %.405 = icmp ne i32 %.399, 0
  %.406 = or i1 %.405, %.404
  br i1 %.406, label %entry.endif.endif.endif.e...endif.6.endif.endif.if, label %entry.endif.endif.endif.e...endif.6.endif.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.6.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.6.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.6.endif.endif.endif

entry.endif.endif.endif.e...endif.6.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.6.endif, %entry.endif.endif.endif.e...endif.6.endif.endif.if
  %.342.3 = phi i1 [ true, %entry.endif.endif.endif.e...endif.6.endif.endif.if ], [ %.342.2, %entry.endif.endif.endif.e...endif.6.endif ]
  %.410.fca.0.load = load ptr, ptr %.395, align 8
  %sunkaddr75 = getelementptr inbounds i8, ptr %.395, i64 8
  %.410.fca.1.load = load ptr, ptr %sunkaddr75, align 8
  %sunkaddr76 = getelementptr inbounds i8, ptr %.395, i64 16
  %.410.fca.2.load = load i64, ptr %sunkaddr76, align 8
  %sunkaddr77 = getelementptr inbounds i8, ptr %.395, i64 32
  %.410.fca.4.load = load ptr, ptr %sunkaddr77, align 8
  %sunkaddr78 = getelementptr inbounds i8, ptr %.395, i64 40
  %.410.fca.5.0.load = load i64, ptr %sunkaddr78, align 8
  %sunkaddr79 = getelementptr inbounds i8, ptr %.395, i64 48
  %.410.fca.6.0.load = load i64, ptr %sunkaddr79, align 8
  %.414 = call ptr @PyTuple_GetItem(ptr %.341, i64 3)
  %.420 = call i64 @PyTuple_Size(ptr %.414)
  %.421.not = icmp ne i64 %.420, 6
  br i1 %.421.not, label %entry.endif.endif.endif.e...if.7, label %entry.endif.endif.endif.e...endif.7, !prof !11

entry.endif.endif.endif.e...if.7:                 ; preds = %entry.endif.endif.endif.e...endif.6.endif.endif.endif
  call void (ptr, ptr, ...) @PyErr_Format(ptr nonnull @PyExc_ValueError, ptr nonnull @".const.size mismatch for tuple, expected 6 element(s) but got %zd", i64 %.420)
  br label %entry.endif.endif.endif.e...endif.7

entry.endif.endif.endif.e...endif.7:              ; preds = %entry.endif.endif.endif.e...if.7, %entry.endif.endif.endif.e...endif.6.endif.endif.endif
  %.427 = call ptr @PyTuple_GetItem(ptr %.414, i64 0)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.428, i8 0, i64 56, i1 false)
  %.432 = call i32 @NRT_adapt_ndarray_from_python(ptr %.427, ptr nonnull %.428)
  %sunkaddr80 = getelementptr inbounds i8, ptr %.428, i64 24
  %.436 = load i64, ptr %sunkaddr80, align 8
  %.437 = icmp ne i64 %.436, 8
  %.438 = icmp ne i32 %.432, 0
  %.439 = or i1 %.438, %.437
  br i1 %.439, label %entry.endif.endif.endif.e...endif.7.endif.if, label %entry.endif.endif.endif.e...endif.7.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.7.endif.if:     ; preds = %entry.endif.endif.endif.e...endif.7
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.7.endif.endif

entry.endif.endif.endif.e...endif.7.endif.endif:  ; preds = %entry.endif.endif.endif.e...endif.7, %entry.endif.endif.endif.e...endif.7.endif.if
  %.415.1 = phi i1 [ true, %entry.endif.endif.endif.e...endif.7.endif.if ], [ %.421.not, %entry.endif.endif.endif.e...endif.7 ]
  %.443.fca.0.load = load ptr, ptr %.428, align 8
  %sunkaddr81 = getelementptr inbounds i8, ptr %.428, i64 8
  %.443.fca.1.load = load ptr, ptr %sunkaddr81, align 8
  %sunkaddr82 = getelementptr inbounds i8, ptr %.428, i64 16
  %.443.fca.2.load = load i64, ptr %sunkaddr82, align 8
  %sunkaddr83 = getelementptr inbounds i8, ptr %.428, i64 32
  %.443.fca.4.load = load ptr, ptr %sunkaddr83, align 8
  %sunkaddr84 = getelementptr inbounds i8, ptr %.428, i64 40
  %.443.fca.5.0.load = load i64, ptr %sunkaddr84, align 8
  %sunkaddr85 = getelementptr inbounds i8, ptr %.428, i64 48
  %.443.fca.6.0.load = load i64, ptr %sunkaddr85, align 8
  %.447 = call ptr @PyTuple_GetItem(ptr %.414, i64 1)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.448, i8 0, i64 56, i1 false)
  %.452 = call i32 @NRT_adapt_ndarray_from_python(ptr %.447, ptr nonnull %.448)
  %sunkaddr86 = getelementptr inbounds i8, ptr %.448, i64 24
  %.456 = load i64, ptr %sunkaddr86, align 8
  %.457 = icmp ne i64 %.456, 8
  %.458 = icmp ne i32 %.452, 0
  %.459 = or i1 %.458, %.457
  br i1 %.459, label %entry.endif.endif.endif.e...if.8, label %entry.endif.endif.endif.e...endif.8, !prof !11

entry.endif.endif.endif.e...if.8:                 ; preds = %entry.endif.endif.endif.e...endif.7.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.8

entry.endif.endif.endif.e...endif.8:              ; preds = %entry.endif.endif.endif.e...endif.7.endif.endif, %entry.endif.endif.endif.e...if.8
  %.415.2 = phi i1 [ true, %entry.endif.endif.endif.e...if.8 ], [ %.415.1, %entry.endif.endif.endif.e...endif.7.endif.endif ]
  %.463.fca.0.load = load ptr, ptr %.448, align 8
  %sunkaddr87 = getelementptr inbounds i8, ptr %.448, i64 8
  %.463.fca.1.load = load ptr, ptr %sunkaddr87, align 8
  %sunkaddr88 = getelementptr inbounds i8, ptr %.448, i64 16
  %.463.fca.2.load = load i64, ptr %sunkaddr88, align 8
  %sunkaddr89 = getelementptr inbounds i8, ptr %.448, i64 32
  %.463.fca.4.load = load ptr, ptr %sunkaddr89, align 8
  %sunkaddr90 = getelementptr inbounds i8, ptr %.448, i64 40
  %.463.fca.5.0.load = load i64, ptr %sunkaddr90, align 8
  %sunkaddr91 = getelementptr inbounds i8, ptr %.448, i64 48
  %.463.fca.6.0.load = load i64, ptr %sunkaddr91, align 8
  %.467 = call ptr @PyTuple_GetItem(ptr %.414, i64 2)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.468, i8 0, i64 56, i1 false)
  %.472 = call i32 @NRT_adapt_ndarray_from_python(ptr %.467, ptr nonnull %.468)
  %sunkaddr92 = getelementptr inbounds i8, ptr %.468, i64 24
  %.476 = load i64, ptr %sunkaddr92, align 8
  %.477 = icmp ne i64 %.476, 8
  %.478 = icmp ne i32 %.472, 0
  %.479 = or i1 %.478, %.477
  br i1 %.479, label %entry.endif.endif.endif.e...endif.8.endif.if, label %entry.endif.endif.endif.e...endif.8.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.8.endif.if:     ; preds = %entry.endif.endif.endif.e...endif.8
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.8.endif.endif

entry.endif.endif.endif.e...endif.8.endif.endif:  ; preds = %entry.endif.endif.endif.e...endif.8, %entry.endif.endif.endif.e...endif.8.endif.if
  %.415.3 = phi i1 [ true, %entry.endif.endif.endif.e...endif.8.endif.if ], [ %.415.2, %entry.endif.endif.endif.e...endif.8 ]
  %.483.fca.0.load = load ptr, ptr %.468, align 8
  %sunkaddr93 = getelementptr inbounds i8, ptr %.468, i64 8
  %.483.fca.1.load = load ptr, ptr %sunkaddr93, align 8
  %sunkaddr94 = getelementptr inbounds i8, ptr %.468, i64 16
  %.483.fca.2.load = load i64, ptr %sunkaddr94, align 8
  %sunkaddr95 = getelementptr inbounds i8, ptr %.468, i64 32
  %.483.fca.4.load = load ptr, ptr %sunkaddr95, align 8
  %sunkaddr96 = getelementptr inbounds i8, ptr %.468, i64 40
  %.483.fca.5.0.load = load i64, ptr %sunkaddr96, align 8
  %sunkaddr97 = getelementptr inbounds i8, ptr %.468, i64 48
  %.483.fca.6.0.load = load i64, ptr %sunkaddr97, align 8
  %.487 = call ptr @PyTuple_GetItem(ptr %.414, i64 3)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.488, i8 0, i64 56, i1 false)
  %.492 = call i32 @NRT_adapt_ndarray_from_python(ptr %.487, ptr nonnull %.488)
  %sunkaddr98 = getelementptr inbounds i8, ptr %.488, i64 24
  %.496 = load i64, ptr %sunkaddr98, align 8
  %.497 = icmp ne i64 %.496, 8
  %.498 = icmp ne i32 %.492, 0
  %.499 = or i1 %.498, %.497
  br i1 %.499, label %entry.endif.endif.endif.e...if.9, label %entry.endif.endif.endif.e...endif.9, !prof !11

entry.endif.endif.endif.e...if.9:                 ; preds = %entry.endif.endif.endif.e...endif.8.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.9

entry.endif.endif.endif.e...endif.9:              ; preds = %entry.endif.endif.endif.e...endif.8.endif.endif, %entry.endif.endif.endif.e...if.9
  %.415.4 = phi i1 [ true, %entry.endif.endif.endif.e...if.9 ], [ %.415.3, %entry.endif.endif.endif.e...endif.8.endif.endif ]
  %.503.fca.0.load = load ptr, ptr %.488, align 8
  %sunkaddr99 = getelementptr inbounds i8, ptr %.488, i64 8
  %.503.fca.1.load = load ptr, ptr %sunkaddr99, align 8
  %sunkaddr100 = getelementptr inbounds i8, ptr %.488, i64 16
  %.503.fca.2.load = load i64, ptr %sunkaddr100, align 8
  %sunkaddr101 = getelementptr inbounds i8, ptr %.488, i64 32
  %.503.fca.4.load = load ptr, ptr %sunkaddr101, align 8
  %sunkaddr102 = getelementptr inbounds i8, ptr %.488, i64 40
  %.503.fca.5.0.load = load i64, ptr %sunkaddr102, align 8
  %sunkaddr103 = getelementptr inbounds i8, ptr %.488, i64 48
  %.503.fca.6.0.load = load i64, ptr %sunkaddr103, align 8
  %.507 = call ptr @PyTuple_GetItem(ptr %.414, i64 4)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.508, i8 0, i64 56, i1 false)
  %.512 = call i32 @NRT_adapt_ndarray_from_python(ptr %.507, ptr nonnull %.508)
  %sunkaddr104 = getelementptr inbounds i8, ptr %.508, i64 24
  %.516 = load i64, ptr %sunkaddr104, align 8
  %.517 = icmp ne i64 %.516, 8
  %.518 = icmp ne i32 %.512, 0
  %.519 = or i1 %.518, %.517
  br i1 %.519, label %entry.endif.endif.endif.e...endif.9.endif.if, label %entry.endif.endif.endif.e...endif.9.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.9.endif.if:     ; preds = %entry.endif.endif.endif.e...endif.9
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.9.endif.endif

entry.endif.endif.endif.e...endif.9.endif.endif:  ; preds = %entry.endif.endif.endif.e...endif.9, %entry.endif.endif.endif.e...endif.9.endif.if
  %.415.5 = phi i1 [ true, %entry.endif.endif.endif.e...endif.9.endif.if ], [ %.415.4, %entry.endif.endif.endif.e...endif.9 ]
  %.523.fca.0.load = load ptr, ptr %.508, align 8
  %sunkaddr105 = getelementptr inbounds i8, ptr %.508, i64 8
  %.523.fca.1.load = load ptr, ptr %sunkaddr105, align 8
  %sunkaddr106 = getelementptr inbounds i8, ptr %.508, i64 16
  %.523.fca.2.load = load i64, ptr %sunkaddr106, align 8
  %sunkaddr107 = getelementptr inbounds i8, ptr %.508, i64 32
  %.523.fca.4.load = load ptr, ptr %sunkaddr107, align 8
  %sunkaddr108 = getelementptr inbounds i8, ptr %.508, i64 40
  %.523.fca.5.0.load = load i64, ptr %sunkaddr108, align 8
  %sunkaddr109 = getelementptr inbounds i8, ptr %.508, i64 48
  %.523.fca.6.0.load = load i64, ptr %sunkaddr109, align 8
  %.527 = call ptr @PyTuple_GetItem(ptr %.414, i64 5)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.528, i8 0, i64 56, i1 false)
  %.532 = call i32 @NRT_adapt_ndarray_from_python(ptr %.527, ptr nonnull %.528)
  %sunkaddr110 = getelementptr inbounds i8, ptr %.528, i64 24
  %.536 = load i64, ptr %sunkaddr110, align 8
  %.537 = icmp ne i64 %.536, 8
  %.538 = icmp ne i32 %.532, 0
  %.539 = or i1 %.538, %.537
  br i1 %.539, label %entry.endif.endif.endif.e...endif.9.endif.endif.if, label %entry.endif.endif.endif.e...endif.9.endif.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.9.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.9.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.9.endif.endif.endif

entry.endif.endif.endif.e...endif.9.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.9.endif.endif.if, %entry.endif.endif.endif.e...endif.9.endif.endif
  %1 = icmp ne i64 %.334, 4
  %.543.fca.0.load = load ptr, ptr %.528, align 8
  %sunkaddr111 = getelementptr inbounds i8, ptr %.528, i64 8
  %.543.fca.1.load = load ptr, ptr %sunkaddr111, align 8
  %sunkaddr112 = getelementptr inbounds i8, ptr %.528, i64 16
  %.543.fca.2.load = load i64, ptr %sunkaddr112, align 8
  %sunkaddr113 = getelementptr inbounds i8, ptr %.528, i64 32
  %.543.fca.4.load = load ptr, ptr %sunkaddr113, align 8
  %sunkaddr114 = getelementptr inbounds i8, ptr %.528, i64 40
  %.543.fca.5.0.load = load i64, ptr %sunkaddr114, align 8
  %sunkaddr115 = getelementptr inbounds i8, ptr %.528, i64 48
  %.543.fca.6.0.load = load i64, ptr %sunkaddr115, align 8
  %brmerge1218 = or i1 %.415.5, %.539
  %.342.3.not = xor i1 %.342.3, true
  %brmerge1219 = or i1 %brmerge1218, %.342.3.not
  %.mux = or i1 %1, %brmerge1218
  br i1 %brmerge1219, label %entry.endif.endif.endif.e...endif.10.endif.endif, label %entry.endif.endif.endif.e...endif.10.endif.if, !prof !15

entry.endif.endif.endif.e...endif.10.endif.if:    ; preds = %entry.endif.endif.endif.e...endif.9.endif.endif.endif
  br label %entry.endif.endif.endif.e...endif.10.endif.endif

entry.endif.endif.endif.e...endif.10.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.9.endif.endif.endif, %entry.endif.endif.endif.e...endif.10.endif.if
  %.329.1 = phi i1 [ %.mux, %entry.endif.endif.endif.e...endif.9.endif.endif.endif ], [ true, %entry.endif.endif.endif.e...endif.10.endif.if ]
  %.569 = call ptr @PyTuple_GetItem(ptr %.328, i64 1)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.570, i8 0, i64 72, i1 false)
  %.574 = call i32 @NRT_adapt_ndarray_from_python(ptr %.569, ptr nonnull %.570)
  %sunkaddr116 = getelementptr inbounds i8, ptr %.570, i64 24
  %.578 = load i64, ptr %sunkaddr116, align 8
  %.579 = icmp ne i64 %.578, 8
  %.580 = icmp ne i32 %.574, 0
  %.581 = or i1 %.580, %.579
  br i1 %.581, label %entry.endif.endif.endif.e...endif.10.endif.endif.if, label %entry.endif.endif.endif.e...endif.10.endif.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.10.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.10.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.10.endif.endif.endif

entry.endif.endif.endif.e...endif.10.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.10.endif.endif.if, %entry.endif.endif.endif.e...endif.10.endif.endif
  %.585.fca.0.load = load ptr, ptr %.570, align 8
  %sunkaddr117 = getelementptr inbounds i8, ptr %.570, i64 8
  %.585.fca.1.load = load ptr, ptr %sunkaddr117, align 8
  %sunkaddr118 = getelementptr inbounds i8, ptr %.570, i64 16
  %.585.fca.2.load = load i64, ptr %sunkaddr118, align 8
  %sunkaddr119 = getelementptr inbounds i8, ptr %.570, i64 32
  %.585.fca.4.load = load ptr, ptr %sunkaddr119, align 8
  %sunkaddr120 = getelementptr inbounds i8, ptr %.570, i64 40
  %.585.fca.5.0.load = load i64, ptr %sunkaddr120, align 8
  %sunkaddr121 = getelementptr inbounds i8, ptr %.570, i64 48
  %.585.fca.5.1.load = load i64, ptr %sunkaddr121, align 8
  %sunkaddr122 = getelementptr inbounds i8, ptr %.570, i64 56
  %.585.fca.6.0.load = load i64, ptr %sunkaddr122, align 8
  %sunkaddr123 = getelementptr inbounds i8, ptr %.570, i64 64
  %.585.fca.6.1.load = load i64, ptr %sunkaddr123, align 8
  br i1 %.581, label %entry.endif.endif.endif.e...if.11, label %entry.endif.endif.endif.e...endif.11, !prof !11

entry.endif.endif.endif.e...if.11:                ; preds = %entry.endif.endif.endif.e...endif.10.endif.endif.endif
  br label %entry.endif.endif.endif.e...endif.11

entry.endif.endif.endif.e...endif.11:             ; preds = %entry.endif.endif.endif.e...if.11, %entry.endif.endif.endif.e...endif.10.endif.endif.endif
  %.329.2 = phi i1 [ true, %entry.endif.endif.endif.e...if.11 ], [ %.329.1, %entry.endif.endif.endif.e...endif.10.endif.endif.endif ]
  %.589 = call ptr @PyTuple_GetItem(ptr %.328, i64 2)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.590, i8 0, i64 72, i1 false)
  %.594 = call i32 @NRT_adapt_ndarray_from_python(ptr %.589, ptr nonnull %.590)
  %sunkaddr124 = getelementptr inbounds i8, ptr %.590, i64 24
  %.598 = load i64, ptr %sunkaddr124, align 8
  %.599 = icmp ne i64 %.598, 8
  %.600 = icmp ne i32 %.594, 0
  %.601 = or i1 %.600, %.599
  br i1 %.601, label %entry.endif.endif.endif.e...endif.11.if, label %entry.endif.endif.endif.e...endif.11.endif, !prof !11

entry.endif.endif.endif.e...endif.11.if:          ; preds = %entry.endif.endif.endif.e...endif.11
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.11.endif

entry.endif.endif.endif.e...endif.11.endif:       ; preds = %entry.endif.endif.endif.e...endif.11.if, %entry.endif.endif.endif.e...endif.11
  %.605.fca.0.load = load ptr, ptr %.590, align 8
  %sunkaddr125 = getelementptr inbounds i8, ptr %.590, i64 8
  %.605.fca.1.load = load ptr, ptr %sunkaddr125, align 8
  %sunkaddr126 = getelementptr inbounds i8, ptr %.590, i64 16
  %.605.fca.2.load = load i64, ptr %sunkaddr126, align 8
  %sunkaddr127 = getelementptr inbounds i8, ptr %.590, i64 32
  %.605.fca.4.load = load ptr, ptr %sunkaddr127, align 8
  %sunkaddr128 = getelementptr inbounds i8, ptr %.590, i64 40
  %.605.fca.5.0.load = load i64, ptr %sunkaddr128, align 8
  %sunkaddr129 = getelementptr inbounds i8, ptr %.590, i64 48
  %.605.fca.5.1.load = load i64, ptr %sunkaddr129, align 8
  %sunkaddr130 = getelementptr inbounds i8, ptr %.590, i64 56
  %.605.fca.6.0.load = load i64, ptr %sunkaddr130, align 8
  %sunkaddr131 = getelementptr inbounds i8, ptr %.590, i64 64
  %.605.fca.6.1.load = load i64, ptr %sunkaddr131, align 8
  br i1 %.601, label %entry.endif.endif.endif.e...endif.11.endif.if, label %entry.endif.endif.endif.e...endif.11.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.11.endif.if:    ; preds = %entry.endif.endif.endif.e...endif.11.endif
  br label %entry.endif.endif.endif.e...endif.11.endif.endif

entry.endif.endif.endif.e...endif.11.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.11.endif.if, %entry.endif.endif.endif.e...endif.11.endif
  %.329.3 = phi i1 [ true, %entry.endif.endif.endif.e...endif.11.endif.if ], [ %.329.2, %entry.endif.endif.endif.e...endif.11.endif ]
  %.609 = call ptr @PyTuple_GetItem(ptr %.328, i64 3)
  %.610 = call ptr @PyNumber_Float(ptr %.609)
  %.611 = call double @PyFloat_AsDouble(ptr %.610)
  call void @Py_DecRef(ptr %.610)
  %.613 = call ptr @PyErr_Occurred()
  %.614.not = icmp ne ptr %.613, null
  %brmerge1220 = or i1 %.329.3, %.614.not
  br i1 %brmerge1220, label %arg2.err, label %entry.endif.endif.endif.e...endif.12, !prof !14

entry.endif.endif.endif.e...endif.12:             ; preds = %entry.endif.endif.endif.e...endif.11.endif.endif
  %.669 = load ptr, ptr %.9, align 8
  %.672 = call ptr @PyNumber_Long(ptr %.669)
  %.673.not = icmp eq ptr %.672, null
  br i1 %.673.not, label %entry.endif.endif.endif.e...endif.12.endif, label %entry.endif.endif.endif.e...endif.12.if, !prof !11

arg3.err:                                         ; preds = %entry.endif.endif.endif.e...endif.12.endif.endif.endif.thread, %arg5.err, %entry.endif.endif.endif.e...endif.12.endif
  call void @NRT_decref(ptr %.370.fca.0.load)
  call void @NRT_decref(ptr %.390.fca.0.load)
  call void @NRT_decref(ptr %.410.fca.0.load)
  call void @NRT_decref(ptr %.443.fca.0.load)
  call void @NRT_decref(ptr %.463.fca.0.load)
  call void @NRT_decref(ptr %.483.fca.0.load)
  call void @NRT_decref(ptr %.503.fca.0.load)
  call void @NRT_decref(ptr %.523.fca.0.load)
  call void @NRT_decref(ptr %.543.fca.0.load)
  call void @NRT_decref(ptr %.585.fca.0.load)
  call void @NRT_decref(ptr %.605.fca.0.load)
  br label %arg2.err

entry.endif.endif.endif.e...endif.12.if:          ; preds = %entry.endif.endif.endif.e...endif.12
  %.675 = call i64 @PyLong_AsLongLong(ptr nonnull %.672)
  call void @Py_DecRef(ptr nonnull %.672)
  br label %entry.endif.endif.endif.e...endif.12.endif

entry.endif.endif.endif.e...endif.12.endif:       ; preds = %entry.endif.endif.endif.e...endif.12.if, %entry.endif.endif.endif.e...endif.12
  %.670.0 = phi i64 [ %.675, %entry.endif.endif.endif.e...endif.12.if ], [ 0, %entry.endif.endif.endif.e...endif.12 ]
  %.680 = call ptr @PyErr_Occurred()
  %.681.not = icmp eq ptr %.680, null
  br i1 %.681.not, label %entry.endif.endif.endif.e...endif.12.endif.endif, label %arg3.err, !prof !12

entry.endif.endif.endif.e...endif.12.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.12.endif
  %.685 = load ptr, ptr %.10, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.686, i8 0, i64 56, i1 false)
  %.690 = call i32 @NRT_adapt_ndarray_from_python(ptr %.685, ptr nonnull %.686)
  %sunkaddr132 = getelementptr inbounds i8, ptr %.686, i64 24
  %.694 = load i64, ptr %sunkaddr132, align 8
  %.695 = icmp ne i64 %.694, 8
  %.696 = icmp ne i32 %.690, 0
  %.697 = or i1 %.696, %.695
  br i1 %.697, label %entry.endif.endif.endif.e...endif.12.endif.endif.endif.thread, label %entry.endif.endif.endif.e...endif.13, !prof !11

entry.endif.endif.endif.e...endif.12.endif.endif.endif.thread: ; preds = %entry.endif.endif.endif.e...endif.12.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %arg3.err

entry.endif.endif.endif.e...endif.13:             ; preds = %entry.endif.endif.endif.e...endif.12.endif.endif
  %.701.fca.0.load = load ptr, ptr %.686, align 8
  %sunkaddr133 = getelementptr inbounds i8, ptr %.686, i64 16
  %.701.fca.2.load = load i64, ptr %sunkaddr133, align 8
  %sunkaddr134 = getelementptr inbounds i8, ptr %.686, i64 32
  %.701.fca.4.load = load ptr, ptr %sunkaddr134, align 8
  %sunkaddr135 = getelementptr inbounds i8, ptr %.686, i64 40
  %.701.fca.5.0.load = load i64, ptr %sunkaddr135, align 8
  %.708 = load ptr, ptr %.11, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.709, i8 0, i64 56, i1 false)
  %.713 = call i32 @NRT_adapt_ndarray_from_python(ptr %.708, ptr nonnull %.709)
  %sunkaddr136 = getelementptr inbounds i8, ptr %.709, i64 24
  %.717 = load i64, ptr %sunkaddr136, align 8
  %.718 = icmp ne i64 %.717, 8
  %.719 = icmp ne i32 %.713, 0
  %.720 = or i1 %.719, %.718
  br i1 %.720, label %entry.endif.endif.endif.e...endif.13.endif.thread, label %entry.endif.endif.endif.e...endif.13.endif.endif, !prof !11

arg5.err:                                         ; preds = %entry.endif.endif.endif.e...endif.13.endif.thread, %arg6.err
  call void @NRT_decref(ptr %.701.fca.0.load)
  br label %arg3.err

entry.endif.endif.endif.e...endif.13.endif.thread: ; preds = %entry.endif.endif.endif.e...endif.13
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %arg5.err

entry.endif.endif.endif.e...endif.13.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.13
  %.724.fca.0.load = load ptr, ptr %.709, align 8
  %sunkaddr137 = getelementptr inbounds i8, ptr %.709, i64 16
  %.724.fca.2.load = load i64, ptr %sunkaddr137, align 8
  %sunkaddr138 = getelementptr inbounds i8, ptr %.709, i64 32
  %.724.fca.4.load = load ptr, ptr %sunkaddr138, align 8
  %sunkaddr139 = getelementptr inbounds i8, ptr %.709, i64 40
  %.724.fca.5.0.load = load i64, ptr %sunkaddr139, align 8
  %.731 = load ptr, ptr %.12, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.732, i8 0, i64 56, i1 false)
  %.736 = call i32 @NRT_adapt_ndarray_from_python(ptr %.731, ptr nonnull %.732)
  %sunkaddr140 = getelementptr inbounds i8, ptr %.732, i64 24
  %.740 = load i64, ptr %sunkaddr140, align 8
  %.741 = icmp ne i64 %.740, 8
  %.742 = icmp ne i32 %.736, 0
  %.743 = or i1 %.742, %.741
  br i1 %.743, label %entry.endif.endif.endif.e...endif.13.endif.endif.endif.thread, label %entry.endif.endif.endif.e...endif.14, !prof !11

arg6.err:                                         ; preds = %entry.endif.endif.endif.e...endif.13.endif.endif.endif.thread, %arg7.err
  call void @NRT_decref(ptr %.724.fca.0.load)
  br label %arg5.err

entry.endif.endif.endif.e...endif.13.endif.endif.endif.thread: ; preds = %entry.endif.endif.endif.e...endif.13.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %arg6.err

entry.endif.endif.endif.e...endif.14:             ; preds = %entry.endif.endif.endif.e...endif.13.endif.endif
  %.747.fca.0.load = load ptr, ptr %.732, align 8
  %.754 = load ptr, ptr %.13, align 8
  %.760 = call i64 @PyTuple_Size(ptr %.754)
  %.761.not = icmp ne i64 %.760, 8
  br i1 %.761.not, label %entry.endif.endif.endif.e...endif.14.if, label %entry.endif.endif.endif.e...endif.14.endif, !prof !11

arg7.err:                                         ; preds = %entry.endif.endif.endif.e...endif.18.thread, %entry.endif.endif.endif.e...endif.18
  call void @NRT_decref(ptr %.747.fca.0.load)
  br label %arg6.err

entry.endif.endif.endif.e...endif.14.if:          ; preds = %entry.endif.endif.endif.e...endif.14
  call void (ptr, ptr, ...) @PyErr_Format(ptr nonnull @PyExc_ValueError, ptr nonnull @".const.size mismatch for tuple, expected 8 element(s) but got %zd", i64 %.760)
  br label %entry.endif.endif.endif.e...endif.14.endif

entry.endif.endif.endif.e...endif.14.endif:       ; preds = %entry.endif.endif.endif.e...endif.14.if, %entry.endif.endif.endif.e...endif.14
  %.767 = call ptr @PyTuple_GetItem(ptr %.754, i64 0)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.768, i8 0, i64 56, i1 false)
  %.772 = call i32 @NRT_adapt_ndarray_from_python(ptr %.767, ptr nonnull %.768)
  %sunkaddr141 = getelementptr inbounds i8, ptr %.768, i64 24
  %.776 = load i64, ptr %sunkaddr141, align 8
  %.777 = icmp ne i64 %.776, 8
  %.778 = icmp ne i32 %.772, 0
  %.779 = or i1 %.778, %.777
  br i1 %.779, label %entry.endif.endif.endif.e...endif.14.endif.endif.if, label %entry.endif.endif.endif.e...endif.14.endif.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.14.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.14.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.14.endif.endif.endif

entry.endif.endif.endif.e...endif.14.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.14.endif, %entry.endif.endif.endif.e...endif.14.endif.endif.if
  %.755.1 = phi i1 [ true, %entry.endif.endif.endif.e...endif.14.endif.endif.if ], [ %.761.not, %entry.endif.endif.endif.e...endif.14.endif ]
  %.783.fca.0.load = load ptr, ptr %.768, align 8
  %sunkaddr142 = getelementptr inbounds i8, ptr %.768, i64 8
  %.783.fca.1.load = load ptr, ptr %sunkaddr142, align 8
  %sunkaddr143 = getelementptr inbounds i8, ptr %.768, i64 16
  %.783.fca.2.load = load i64, ptr %sunkaddr143, align 8
  %sunkaddr144 = getelementptr inbounds i8, ptr %.768, i64 32
  %.783.fca.4.load = load ptr, ptr %sunkaddr144, align 8
  %sunkaddr145 = getelementptr inbounds i8, ptr %.768, i64 40
  %.783.fca.5.0.load = load i64, ptr %sunkaddr145, align 8
  %sunkaddr146 = getelementptr inbounds i8, ptr %.768, i64 48
  %.783.fca.6.0.load = load i64, ptr %sunkaddr146, align 8
  %.787 = call ptr @PyTuple_GetItem(ptr %.754, i64 1)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.788, i8 0, i64 56, i1 false)
  %.792 = call i32 @NRT_adapt_ndarray_from_python(ptr %.787, ptr nonnull %.788)
  %sunkaddr147 = getelementptr inbounds i8, ptr %.788, i64 24
  %.796 = load i64, ptr %sunkaddr147, align 8
  %.797 = icmp ne i64 %.796, 8
  %.798 = icmp ne i32 %.792, 0
  %.799 = or i1 %.798, %.797
  br i1 %.799, label %entry.endif.endif.endif.e...endif.15.if, label %entry.endif.endif.endif.e...endif.15.endif, !prof !11

entry.endif.endif.endif.e...endif.15.if:          ; preds = %entry.endif.endif.endif.e...endif.14.endif.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.15.endif

entry.endif.endif.endif.e...endif.15.endif:       ; preds = %entry.endif.endif.endif.e...endif.14.endif.endif.endif, %entry.endif.endif.endif.e...endif.15.if
  %.755.2 = phi i1 [ true, %entry.endif.endif.endif.e...endif.15.if ], [ %.755.1, %entry.endif.endif.endif.e...endif.14.endif.endif.endif ]
  %.803.fca.0.load = load ptr, ptr %.788, align 8
  %sunkaddr148 = getelementptr inbounds i8, ptr %.788, i64 8
  %.803.fca.1.load = load ptr, ptr %sunkaddr148, align 8
  %sunkaddr149 = getelementptr inbounds i8, ptr %.788, i64 16
  %.803.fca.2.load = load i64, ptr %sunkaddr149, align 8
  %sunkaddr150 = getelementptr inbounds i8, ptr %.788, i64 32
  %.803.fca.4.load = load ptr, ptr %sunkaddr150, align 8
  %sunkaddr151 = getelementptr inbounds i8, ptr %.788, i64 40
  %.803.fca.5.0.load = load i64, ptr %sunkaddr151, align 8
  %sunkaddr152 = getelementptr inbounds i8, ptr %.788, i64 48
  %.803.fca.6.0.load = load i64, ptr %sunkaddr152, align 8
  %.807 = call ptr @PyTuple_GetItem(ptr %.754, i64 2)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.808, i8 0, i64 56, i1 false)
  %.812 = call i32 @NRT_adapt_ndarray_from_python(ptr %.807, ptr nonnull %.808)
  %sunkaddr153 = getelementptr inbounds i8, ptr %.808, i64 24
  %.816 = load i64, ptr %sunkaddr153, align 8
  %.817 = icmp ne i64 %.816, 8
  %.818 = icmp ne i32 %.812, 0
  %.819 = or i1 %.818, %.817
  br i1 %.819, label %entry.endif.endif.endif.e...endif.15.endif.endif.if, label %entry.endif.endif.endif.e...endif.15.endif.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.15.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.15.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.15.endif.endif.endif

entry.endif.endif.endif.e...endif.15.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.15.endif, %entry.endif.endif.endif.e...endif.15.endif.endif.if
  %.755.3 = phi i1 [ true, %entry.endif.endif.endif.e...endif.15.endif.endif.if ], [ %.755.2, %entry.endif.endif.endif.e...endif.15.endif ]
  %.823.fca.0.load = load ptr, ptr %.808, align 8
  %sunkaddr154 = getelementptr inbounds i8, ptr %.808, i64 8
  %.823.fca.1.load = load ptr, ptr %sunkaddr154, align 8
  %sunkaddr155 = getelementptr inbounds i8, ptr %.808, i64 16
  %.823.fca.2.load = load i64, ptr %sunkaddr155, align 8
  %sunkaddr156 = getelementptr inbounds i8, ptr %.808, i64 32
  %.823.fca.4.load = load ptr, ptr %sunkaddr156, align 8
  %sunkaddr157 = getelementptr inbounds i8, ptr %.808, i64 40
  %.823.fca.5.0.load = load i64, ptr %sunkaddr157, align 8
  %sunkaddr158 = getelementptr inbounds i8, ptr %.808, i64 48
  %.823.fca.6.0.load = load i64, ptr %sunkaddr158, align 8
  %.827 = call ptr @PyTuple_GetItem(ptr %.754, i64 3)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.828, i8 0, i64 56, i1 false)
  %.832 = call i32 @NRT_adapt_ndarray_from_python(ptr %.827, ptr nonnull %.828)
  %sunkaddr159 = getelementptr inbounds i8, ptr %.828, i64 24
  %.836 = load i64, ptr %sunkaddr159, align 8
  %.837 = icmp ne i64 %.836, 8
  %.838 = icmp ne i32 %.832, 0
  %.839 = or i1 %.838, %.837
  br i1 %.839, label %entry.endif.endif.endif.e...endif.16.if, label %entry.endif.endif.endif.e...endif.16.endif, !prof !11

entry.endif.endif.endif.e...endif.16.if:          ; preds = %entry.endif.endif.endif.e...endif.15.endif.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.16.endif

entry.endif.endif.endif.e...endif.16.endif:       ; preds = %entry.endif.endif.endif.e...endif.15.endif.endif.endif, %entry.endif.endif.endif.e...endif.16.if
  %.755.4 = phi i1 [ true, %entry.endif.endif.endif.e...endif.16.if ], [ %.755.3, %entry.endif.endif.endif.e...endif.15.endif.endif.endif ]
  %.843.fca.0.load = load ptr, ptr %.828, align 8
  %sunkaddr160 = getelementptr inbounds i8, ptr %.828, i64 8
  %.843.fca.1.load = load ptr, ptr %sunkaddr160, align 8
  %sunkaddr161 = getelementptr inbounds i8, ptr %.828, i64 16
  %.843.fca.2.load = load i64, ptr %sunkaddr161, align 8
  %sunkaddr162 = getelementptr inbounds i8, ptr %.828, i64 32
  %.843.fca.4.load = load ptr, ptr %sunkaddr162, align 8
  %sunkaddr163 = getelementptr inbounds i8, ptr %.828, i64 40
  %.843.fca.5.0.load = load i64, ptr %sunkaddr163, align 8
  %sunkaddr164 = getelementptr inbounds i8, ptr %.828, i64 48
  %.843.fca.6.0.load = load i64, ptr %sunkaddr164, align 8
  %.847 = call ptr @PyTuple_GetItem(ptr %.754, i64 4)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.848, i8 0, i64 56, i1 false)
  %.852 = call i32 @NRT_adapt_ndarray_from_python(ptr %.847, ptr nonnull %.848)
  %sunkaddr165 = getelementptr inbounds i8, ptr %.848, i64 24
  %.856 = load i64, ptr %sunkaddr165, align 8
  %.857 = icmp ne i64 %.856, 8
  %.858 = icmp ne i32 %.852, 0
  %.859 = or i1 %.858, %.857
  br i1 %.859, label %entry.endif.endif.endif.e...endif.16.endif.endif.if, label %entry.endif.endif.endif.e...endif.16.endif.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.16.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.16.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.16.endif.endif.endif

entry.endif.endif.endif.e...endif.16.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.16.endif, %entry.endif.endif.endif.e...endif.16.endif.endif.if
  %.755.5 = phi i1 [ true, %entry.endif.endif.endif.e...endif.16.endif.endif.if ], [ %.755.4, %entry.endif.endif.endif.e...endif.16.endif ]
  %.863.fca.0.load = load ptr, ptr %.848, align 8
  %sunkaddr166 = getelementptr inbounds i8, ptr %.848, i64 8
  %.863.fca.1.load = load ptr, ptr %sunkaddr166, align 8
  %sunkaddr167 = getelementptr inbounds i8, ptr %.848, i64 16
  %.863.fca.2.load = load i64, ptr %sunkaddr167, align 8
  %sunkaddr168 = getelementptr inbounds i8, ptr %.848, i64 32
  %.863.fca.4.load = load ptr, ptr %sunkaddr168, align 8
  %sunkaddr169 = getelementptr inbounds i8, ptr %.848, i64 40
  %.863.fca.5.0.load = load i64, ptr %sunkaddr169, align 8
  %sunkaddr170 = getelementptr inbounds i8, ptr %.848, i64 48
  %.863.fca.6.0.load = load i64, ptr %sunkaddr170, align 8
  %.867 = call ptr @PyTuple_GetItem(ptr %.754, i64 5)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.868, i8 0, i64 56, i1 false)
  %.872 = call i32 @NRT_adapt_ndarray_from_python(ptr %.867, ptr nonnull %.868)
  %sunkaddr171 = getelementptr inbounds i8, ptr %.868, i64 24
  %.876 = load i64, ptr %sunkaddr171, align 8
  %.877 = icmp ne i64 %.876, 8
  %.878 = icmp ne i32 %.872, 0
  %.879 = or i1 %.878, %.877
  br i1 %.879, label %entry.endif.endif.endif.e...endif.17.if, label %entry.endif.endif.endif.e...endif.17.endif, !prof !11

entry.endif.endif.endif.e...endif.17.if:          ; preds = %entry.endif.endif.endif.e...endif.16.endif.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.17.endif

entry.endif.endif.endif.e...endif.17.endif:       ; preds = %entry.endif.endif.endif.e...endif.16.endif.endif.endif, %entry.endif.endif.endif.e...endif.17.if
  %.755.6 = phi i1 [ true, %entry.endif.endif.endif.e...endif.17.if ], [ %.755.5, %entry.endif.endif.endif.e...endif.16.endif.endif.endif ]
  %.883.fca.0.load = load ptr, ptr %.868, align 8
  %sunkaddr172 = getelementptr inbounds i8, ptr %.868, i64 8
  %.883.fca.1.load = load ptr, ptr %sunkaddr172, align 8
  %sunkaddr173 = getelementptr inbounds i8, ptr %.868, i64 16
  %.883.fca.2.load = load i64, ptr %sunkaddr173, align 8
  %sunkaddr174 = getelementptr inbounds i8, ptr %.868, i64 32
  %.883.fca.4.load = load ptr, ptr %sunkaddr174, align 8
  %sunkaddr175 = getelementptr inbounds i8, ptr %.868, i64 40
  %.883.fca.5.0.load = load i64, ptr %sunkaddr175, align 8
  %sunkaddr176 = getelementptr inbounds i8, ptr %.868, i64 48
  %.883.fca.6.0.load = load i64, ptr %sunkaddr176, align 8
  %.887 = call ptr @PyTuple_GetItem(ptr %.754, i64 6)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.888, i8 0, i64 56, i1 false)
  %.892 = call i32 @NRT_adapt_ndarray_from_python(ptr %.887, ptr nonnull %.888)
  %sunkaddr177 = getelementptr inbounds i8, ptr %.888, i64 24
  %.896 = load i64, ptr %sunkaddr177, align 8
  %.897 = icmp ne i64 %.896, 8
  %.898 = icmp ne i32 %.892, 0
  %.899 = or i1 %.898, %.897
  br i1 %.899, label %entry.endif.endif.endif.e...endif.17.endif.endif.if, label %entry.endif.endif.endif.e...endif.17.endif.endif.endif, !prof !11

entry.endif.endif.endif.e...endif.17.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.17.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %entry.endif.endif.endif.e...endif.17.endif.endif.endif

entry.endif.endif.endif.e...endif.17.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.17.endif, %entry.endif.endif.endif.e...endif.17.endif.endif.if
  %.755.7 = phi i1 [ true, %entry.endif.endif.endif.e...endif.17.endif.endif.if ], [ %.755.6, %entry.endif.endif.endif.e...endif.17.endif ]
  %.903.fca.0.load = load ptr, ptr %.888, align 8
  %sunkaddr178 = getelementptr inbounds i8, ptr %.888, i64 8
  %.903.fca.1.load = load ptr, ptr %sunkaddr178, align 8
  %sunkaddr179 = getelementptr inbounds i8, ptr %.888, i64 16
  %.903.fca.2.load = load i64, ptr %sunkaddr179, align 8
  %sunkaddr180 = getelementptr inbounds i8, ptr %.888, i64 32
  %.903.fca.4.load = load ptr, ptr %sunkaddr180, align 8
  %sunkaddr181 = getelementptr inbounds i8, ptr %.888, i64 40
  %.903.fca.5.0.load = load i64, ptr %sunkaddr181, align 8
  %sunkaddr182 = getelementptr inbounds i8, ptr %.888, i64 48
  %.903.fca.6.0.load = load i64, ptr %sunkaddr182, align 8
  %.907 = call ptr @PyTuple_GetItem(ptr %.754, i64 7)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.908, i8 0, i64 56, i1 false)
  %.912 = call i32 @NRT_adapt_ndarray_from_python(ptr %.907, ptr nonnull %.908)
  %sunkaddr183 = getelementptr inbounds i8, ptr %.908, i64 24
  %.916 = load i64, ptr %sunkaddr183, align 8
  %.917 = icmp ne i64 %.916, 8
  %.918 = icmp ne i32 %.912, 0
  %.919 = or i1 %.918, %.917
  br i1 %.919, label %entry.endif.endif.endif.e...endif.18.thread, label %entry.endif.endif.endif.e...endif.18, !prof !11

entry.endif.endif.endif.e...endif.18.thread:      ; preds = %entry.endif.endif.endif.e...endif.17.endif.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_TypeError, ptr nonnull @".const.can't unbox array from PyObject into native value.  The object maybe of a different type")
  br label %arg7.err

entry.endif.endif.endif.e...endif.18:             ; preds = %entry.endif.endif.endif.e...endif.17.endif.endif.endif
  br i1 %.755.7, label %arg7.err, label %entry.endif.endif.endif.e...endif.19.endif.endif, !prof !16

entry.endif.endif.endif.e...endif.19.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.18
  %sunkaddr184 = getelementptr inbounds i8, ptr %.908, i64 48
  %.923.fca.6.0.load = load i64, ptr %sunkaddr184, align 8
  %sunkaddr185 = getelementptr inbounds i8, ptr %.908, i64 40
  %.923.fca.5.0.load = load i64, ptr %sunkaddr185, align 8
  %sunkaddr186 = getelementptr inbounds i8, ptr %.908, i64 32
  %.923.fca.4.load = load ptr, ptr %sunkaddr186, align 8
  %sunkaddr187 = getelementptr inbounds i8, ptr %.908, i64 16
  %.923.fca.2.load = load i64, ptr %sunkaddr187, align 8
  %sunkaddr188 = getelementptr inbounds i8, ptr %.908, i64 8
  %.923.fca.1.load = load ptr, ptr %sunkaddr188, align 8
  %.923.fca.0.load = load ptr, ptr %.908, align 8
  %.989 = call ptr @PyEval_SaveThread()
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(696) %.990, i8 0, i64 696, i1 false)
  %.1077 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks13follow_blocksB2v1B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqEpgoEBZSIkILKIJAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2934ConstantForce_28float64_20x_201_29274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29478BlockElements_28ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20float64_29x5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29vvvv(ptr nonnull %.990, ptr nonnull %excinfo, double %.45, ptr %.68.fca.0.load, ptr %.68.fca.1.load, i64 %.68.fca.2.load, i64 %.61, ptr %.68.fca.4.load, i64 %.68.fca.5.0.load, i64 %.68.fca.6.0.load, ptr %.88.fca.0.load, ptr %.88.fca.1.load, i64 %.88.fca.2.load, i64 8, ptr %.88.fca.4.load, i64 %.88.fca.5.0.load, i64 %.88.fca.6.0.load, double %.122, ptr %.166.fca.0.load, ptr %.166.fca.1.load, i64 %.166.fca.2.load, i64 %.159, ptr %.166.fca.4.load, i64 %.166.fca.5.0.load, i64 %.166.fca.5.1.load, i64 %.166.fca.6.0.load, i64 %.166.fca.6.1.load, ptr %.186.fca.0.load, ptr %.186.fca.1.load, i64 %.186.fca.2.load, i64 %.179, ptr %.186.fca.4.load, i64 %.186.fca.5.0.load, i64 %.186.fca.5.1.load, i64 %.186.fca.6.0.load, i64 %.186.fca.6.1.load, ptr %.206.fca.0.load, ptr %.206.fca.1.load, i64 %.206.fca.2.load, i64 %.199, ptr %.206.fca.4.load, i64 %.206.fca.5.0.load, i64 %.206.fca.6.0.load, ptr %.226.fca.0.load, ptr %.226.fca.1.load, i64 %.226.fca.2.load, i64 %.219, ptr %.226.fca.4.load, i64 %.226.fca.5.0.load, i64 %.226.fca.6.0.load, ptr %.246.fca.0.load, ptr %.246.fca.1.load, i64 %.246.fca.2.load, i64 %.239, ptr %.246.fca.4.load, i64 %.246.fca.5.0.load, i64 %.246.fca.6.0.load, ptr %.266.fca.0.load, ptr %.266.fca.1.load, i64 %.266.fca.2.load, i64 %.259, ptr %.266.fca.4.load, i64 %.266.fca.5.0.load, i64 %.266.fca.6.0.load, ptr %.286.fca.0.load, ptr %.286.fca.1.load, i64 %.286.fca.2.load, i64 8, ptr %.286.fca.4.load, i64 %.286.fca.5.0.load, i64 %.286.fca.6.0.load, ptr %.370.fca.0.load, ptr %.370.fca.1.load, i64 %.370.fca.2.load, i64 %.363, ptr %.370.fca.4.load, i64 %.370.fca.5.0.load, i64 %.370.fca.5.1.load, i64 %.370.fca.5.2.load, i64 %.370.fca.6.0.load, i64 %.370.fca.6.1.load, i64 %.370.fca.6.2.load, ptr %.390.fca.0.load, ptr %.390.fca.1.load, i64 %.390.fca.2.load, i64 %.383, ptr %.390.fca.4.load, i64 %.390.fca.5.0.load, i64 %.390.fca.6.0.load, ptr %.410.fca.0.load, ptr %.410.fca.1.load, i64 %.410.fca.2.load, i64 %.403, ptr %.410.fca.4.load, i64 %.410.fca.5.0.load, i64 %.410.fca.6.0.load, ptr %.443.fca.0.load, ptr %.443.fca.1.load, i64 %.443.fca.2.load, i64 %.436, ptr %.443.fca.4.load, i64 %.443.fca.5.0.load, i64 %.443.fca.6.0.load, ptr %.463.fca.0.load, ptr %.463.fca.1.load, i64 %.463.fca.2.load, i64 %.456, ptr %.463.fca.4.load, i64 %.463.fca.5.0.load, i64 %.463.fca.6.0.load, ptr %.483.fca.0.load, ptr %.483.fca.1.load, i64 %.483.fca.2.load, i64 %.476, ptr %.483.fca.4.load, i64 %.483.fca.5.0.load, i64 %.483.fca.6.0.load, ptr %.503.fca.0.load, ptr %.503.fca.1.load, i64 %.503.fca.2.load, i64 %.496, ptr %.503.fca.4.load, i64 %.503.fca.5.0.load, i64 %.503.fca.6.0.load, ptr %.523.fca.0.load, ptr %.523.fca.1.load, i64 %.523.fca.2.load, i64 %.516, ptr %.523.fca.4.load, i64 %.523.fca.5.0.load, i64 %.523.fca.6.0.load, ptr %.543.fca.0.load, ptr %.543.fca.1.load, i64 %.543.fca.2.load, i64 %.536, ptr %.543.fca.4.load, i64 %.543.fca.5.0.load, i64 %.543.fca.6.0.load, ptr %.585.fca.0.load, ptr %.585.fca.1.load, i64 %.585.fca.2.load, i64 %.578, ptr %.585.fca.4.load, i64 %.585.fca.5.0.load, i64 %.585.fca.5.1.load, i64 %.585.fca.6.0.load, i64 %.585.fca.6.1.load, ptr %.605.fca.0.load, ptr %.605.fca.1.load, i64 %.605.fca.2.load, i64 %.598, ptr %.605.fca.4.load, i64 %.605.fca.5.0.load, i64 %.605.fca.5.1.load, i64 %.605.fca.6.0.load, i64 %.605.fca.6.1.load, double %.611, i64 %.670.0, ptr %.701.fca.0.load, ptr poison, i64 %.701.fca.2.load, i64 poison, ptr %.701.fca.4.load, i64 %.701.fca.5.0.load, i64 poison, ptr %.724.fca.0.load, ptr poison, i64 %.724.fca.2.load, i64 poison, ptr %.724.fca.4.load, i64 %.724.fca.5.0.load, i64 poison, ptr %.747.fca.0.load, ptr poison, i64 poison, i64 poison, ptr poison, i64 poison, i64 poison, ptr %.783.fca.0.load, ptr %.783.fca.1.load, i64 %.783.fca.2.load, i64 %.776, ptr %.783.fca.4.load, i64 %.783.fca.5.0.load, i64 %.783.fca.6.0.load, ptr %.803.fca.0.load, ptr %.803.fca.1.load, i64 %.803.fca.2.load, i64 %.796, ptr %.803.fca.4.load, i64 %.803.fca.5.0.load, i64 %.803.fca.6.0.load, ptr %.823.fca.0.load, ptr %.823.fca.1.load, i64 %.823.fca.2.load, i64 %.816, ptr %.823.fca.4.load, i64 %.823.fca.5.0.load, i64 %.823.fca.6.0.load, ptr %.843.fca.0.load, ptr %.843.fca.1.load, i64 %.843.fca.2.load, i64 %.836, ptr %.843.fca.4.load, i64 %.843.fca.5.0.load, i64 %.843.fca.6.0.load, ptr %.863.fca.0.load, ptr %.863.fca.1.load, i64 %.863.fca.2.load, i64 %.856, ptr %.863.fca.4.load, i64 %.863.fca.5.0.load, i64 %.863.fca.6.0.load, ptr %.883.fca.0.load, ptr %.883.fca.1.load, i64 %.883.fca.2.load, i64 %.876, ptr %.883.fca.4.load, i64 %.883.fca.5.0.load, i64 %.883.fca.6.0.load, ptr %.903.fca.0.load, ptr %.903.fca.1.load, i64 %.903.fca.2.load, i64 %.896, ptr %.903.fca.4.load, i64 %.903.fca.5.0.load, i64 %.903.fca.6.0.load, ptr %.923.fca.0.load, ptr %.923.fca.1.load, i64 %.923.fca.2.load, i64 8, ptr %.923.fca.4.load, i64 %.923.fca.5.0.load, i64 %.923.fca.6.0.load, ptr null, ptr null, ptr poison, ptr poison) #3
  %.1078 = load ptr, ptr %excinfo, align 8
  %.1087.fca.0.0.0.0.load = load ptr, ptr %.990, align 8
  %sunkaddr189 = getelementptr inbounds i8, ptr %.990, i64 8
  %.1087.fca.0.0.0.1.load = load ptr, ptr %sunkaddr189, align 8
  %sunkaddr190 = getelementptr inbounds i8, ptr %.990, i64 16
  %.1087.fca.0.0.0.2.load = load i64, ptr %sunkaddr190, align 8
  %sunkaddr191 = getelementptr inbounds i8, ptr %.990, i64 24
  %.1087.fca.0.0.0.3.load = load i64, ptr %sunkaddr191, align 8
  %sunkaddr192 = getelementptr inbounds i8, ptr %.990, i64 32
  %.1087.fca.0.0.0.4.load = load ptr, ptr %sunkaddr192, align 8
  %sunkaddr193 = getelementptr inbounds i8, ptr %.990, i64 40
  %.1087.fca.0.0.0.5.0.load = load i64, ptr %sunkaddr193, align 8
  %sunkaddr194 = getelementptr inbounds i8, ptr %.990, i64 48
  %.1087.fca.0.0.0.5.1.load = load i64, ptr %sunkaddr194, align 8
  %sunkaddr195 = getelementptr inbounds i8, ptr %.990, i64 56
  %.1087.fca.0.0.0.5.2.load = load i64, ptr %sunkaddr195, align 8
  %sunkaddr196 = getelementptr inbounds i8, ptr %.990, i64 64
  %.1087.fca.0.0.0.6.0.load = load i64, ptr %sunkaddr196, align 8
  %sunkaddr197 = getelementptr inbounds i8, ptr %.990, i64 72
  %.1087.fca.0.0.0.6.1.load = load i64, ptr %sunkaddr197, align 8
  %sunkaddr198 = getelementptr inbounds i8, ptr %.990, i64 80
  %.1087.fca.0.0.0.6.2.load = load i64, ptr %sunkaddr198, align 8
  %sunkaddr199 = getelementptr inbounds i8, ptr %.990, i64 88
  %.1087.fca.0.0.1.0.load = load ptr, ptr %sunkaddr199, align 8
  %sunkaddr200 = getelementptr inbounds i8, ptr %.990, i64 96
  %.1087.fca.0.0.1.1.load = load ptr, ptr %sunkaddr200, align 8
  %sunkaddr201 = getelementptr inbounds i8, ptr %.990, i64 104
  %.1087.fca.0.0.1.2.load = load i64, ptr %sunkaddr201, align 8
  %sunkaddr202 = getelementptr inbounds i8, ptr %.990, i64 112
  %.1087.fca.0.0.1.3.load = load i64, ptr %sunkaddr202, align 8
  %sunkaddr203 = getelementptr inbounds i8, ptr %.990, i64 120
  %.1087.fca.0.0.1.4.load = load ptr, ptr %sunkaddr203, align 8
  %sunkaddr204 = getelementptr inbounds i8, ptr %.990, i64 128
  %.1087.fca.0.0.1.5.0.load = load i64, ptr %sunkaddr204, align 8
  %sunkaddr205 = getelementptr inbounds i8, ptr %.990, i64 136
  %.1087.fca.0.0.1.6.0.load = load i64, ptr %sunkaddr205, align 8
  %sunkaddr206 = getelementptr inbounds i8, ptr %.990, i64 144
  %.1087.fca.0.0.2.0.load = load ptr, ptr %sunkaddr206, align 8
  %sunkaddr207 = getelementptr inbounds i8, ptr %.990, i64 152
  %.1087.fca.0.0.2.1.load = load ptr, ptr %sunkaddr207, align 8
  %sunkaddr208 = getelementptr inbounds i8, ptr %.990, i64 160
  %.1087.fca.0.0.2.2.load = load i64, ptr %sunkaddr208, align 8
  %sunkaddr209 = getelementptr inbounds i8, ptr %.990, i64 168
  %.1087.fca.0.0.2.3.load = load i64, ptr %sunkaddr209, align 8
  %sunkaddr210 = getelementptr inbounds i8, ptr %.990, i64 176
  %.1087.fca.0.0.2.4.load = load ptr, ptr %sunkaddr210, align 8
  %sunkaddr211 = getelementptr inbounds i8, ptr %.990, i64 184
  %.1087.fca.0.0.2.5.0.load = load i64, ptr %sunkaddr211, align 8
  %sunkaddr212 = getelementptr inbounds i8, ptr %.990, i64 192
  %.1087.fca.0.0.2.6.0.load = load i64, ptr %sunkaddr212, align 8
  %sunkaddr213 = getelementptr inbounds i8, ptr %.990, i64 200
  %.1087.fca.0.0.3.0.0.load = load ptr, ptr %sunkaddr213, align 8
  %sunkaddr214 = getelementptr inbounds i8, ptr %.990, i64 208
  %.1087.fca.0.0.3.0.1.load = load ptr, ptr %sunkaddr214, align 8
  %sunkaddr215 = getelementptr inbounds i8, ptr %.990, i64 216
  %.1087.fca.0.0.3.0.2.load = load i64, ptr %sunkaddr215, align 8
  %sunkaddr216 = getelementptr inbounds i8, ptr %.990, i64 224
  %.1087.fca.0.0.3.0.3.load = load i64, ptr %sunkaddr216, align 8
  %sunkaddr217 = getelementptr inbounds i8, ptr %.990, i64 232
  %.1087.fca.0.0.3.0.4.load = load ptr, ptr %sunkaddr217, align 8
  %sunkaddr218 = getelementptr inbounds i8, ptr %.990, i64 240
  %.1087.fca.0.0.3.0.5.0.load = load i64, ptr %sunkaddr218, align 8
  %sunkaddr219 = getelementptr inbounds i8, ptr %.990, i64 248
  %.1087.fca.0.0.3.0.6.0.load = load i64, ptr %sunkaddr219, align 8
  %sunkaddr220 = getelementptr inbounds i8, ptr %.990, i64 256
  %.1087.fca.0.0.3.1.0.load = load ptr, ptr %sunkaddr220, align 8
  %sunkaddr221 = getelementptr inbounds i8, ptr %.990, i64 264
  %.1087.fca.0.0.3.1.1.load = load ptr, ptr %sunkaddr221, align 8
  %sunkaddr222 = getelementptr inbounds i8, ptr %.990, i64 272
  %.1087.fca.0.0.3.1.2.load = load i64, ptr %sunkaddr222, align 8
  %sunkaddr223 = getelementptr inbounds i8, ptr %.990, i64 280
  %.1087.fca.0.0.3.1.3.load = load i64, ptr %sunkaddr223, align 8
  %sunkaddr224 = getelementptr inbounds i8, ptr %.990, i64 288
  %.1087.fca.0.0.3.1.4.load = load ptr, ptr %sunkaddr224, align 8
  %sunkaddr225 = getelementptr inbounds i8, ptr %.990, i64 296
  %.1087.fca.0.0.3.1.5.0.load = load i64, ptr %sunkaddr225, align 8
  %sunkaddr226 = getelementptr inbounds i8, ptr %.990, i64 304
  %.1087.fca.0.0.3.1.6.0.load = load i64, ptr %sunkaddr226, align 8
  %sunkaddr227 = getelementptr inbounds i8, ptr %.990, i64 312
  %.1087.fca.0.0.3.2.0.load = load ptr, ptr %sunkaddr227, align 8
  %sunkaddr228 = getelementptr inbounds i8, ptr %.990, i64 320
  %.1087.fca.0.0.3.2.1.load = load ptr, ptr %sunkaddr228, align 8
  %sunkaddr229 = getelementptr inbounds i8, ptr %.990, i64 328
  %.1087.fca.0.0.3.2.2.load = load i64, ptr %sunkaddr229, align 8
  %sunkaddr230 = getelementptr inbounds i8, ptr %.990, i64 336
  %.1087.fca.0.0.3.2.3.load = load i64, ptr %sunkaddr230, align 8
  %sunkaddr231 = getelementptr inbounds i8, ptr %.990, i64 344
  %.1087.fca.0.0.3.2.4.load = load ptr, ptr %sunkaddr231, align 8
  %sunkaddr232 = getelementptr inbounds i8, ptr %.990, i64 352
  %.1087.fca.0.0.3.2.5.0.load = load i64, ptr %sunkaddr232, align 8
  %sunkaddr233 = getelementptr inbounds i8, ptr %.990, i64 360
  %.1087.fca.0.0.3.2.6.0.load = load i64, ptr %sunkaddr233, align 8
  %sunkaddr234 = getelementptr inbounds i8, ptr %.990, i64 368
  %.1087.fca.0.0.3.3.0.load = load ptr, ptr %sunkaddr234, align 8
  %sunkaddr235 = getelementptr inbounds i8, ptr %.990, i64 376
  %.1087.fca.0.0.3.3.1.load = load ptr, ptr %sunkaddr235, align 8
  %sunkaddr236 = getelementptr inbounds i8, ptr %.990, i64 384
  %.1087.fca.0.0.3.3.2.load = load i64, ptr %sunkaddr236, align 8
  %sunkaddr237 = getelementptr inbounds i8, ptr %.990, i64 392
  %.1087.fca.0.0.3.3.3.load = load i64, ptr %sunkaddr237, align 8
  %sunkaddr238 = getelementptr inbounds i8, ptr %.990, i64 400
  %.1087.fca.0.0.3.3.4.load = load ptr, ptr %sunkaddr238, align 8
  %sunkaddr239 = getelementptr inbounds i8, ptr %.990, i64 408
  %.1087.fca.0.0.3.3.5.0.load = load i64, ptr %sunkaddr239, align 8
  %sunkaddr240 = getelementptr inbounds i8, ptr %.990, i64 416
  %.1087.fca.0.0.3.3.6.0.load = load i64, ptr %sunkaddr240, align 8
  %sunkaddr241 = getelementptr inbounds i8, ptr %.990, i64 424
  %.1087.fca.0.0.3.4.0.load = load ptr, ptr %sunkaddr241, align 8
  %sunkaddr242 = getelementptr inbounds i8, ptr %.990, i64 432
  %.1087.fca.0.0.3.4.1.load = load ptr, ptr %sunkaddr242, align 8
  %sunkaddr243 = getelementptr inbounds i8, ptr %.990, i64 440
  %.1087.fca.0.0.3.4.2.load = load i64, ptr %sunkaddr243, align 8
  %sunkaddr244 = getelementptr inbounds i8, ptr %.990, i64 448
  %.1087.fca.0.0.3.4.3.load = load i64, ptr %sunkaddr244, align 8
  %sunkaddr245 = getelementptr inbounds i8, ptr %.990, i64 456
  %.1087.fca.0.0.3.4.4.load = load ptr, ptr %sunkaddr245, align 8
  %sunkaddr246 = getelementptr inbounds i8, ptr %.990, i64 464
  %.1087.fca.0.0.3.4.5.0.load = load i64, ptr %sunkaddr246, align 8
  %sunkaddr247 = getelementptr inbounds i8, ptr %.990, i64 472
  %.1087.fca.0.0.3.4.6.0.load = load i64, ptr %sunkaddr247, align 8
  %sunkaddr248 = getelementptr inbounds i8, ptr %.990, i64 480
  %.1087.fca.0.0.3.5.0.load = load ptr, ptr %sunkaddr248, align 8
  %sunkaddr249 = getelementptr inbounds i8, ptr %.990, i64 488
  %.1087.fca.0.0.3.5.1.load = load ptr, ptr %sunkaddr249, align 8
  %sunkaddr250 = getelementptr inbounds i8, ptr %.990, i64 496
  %.1087.fca.0.0.3.5.2.load = load i64, ptr %sunkaddr250, align 8
  %sunkaddr251 = getelementptr inbounds i8, ptr %.990, i64 504
  %.1087.fca.0.0.3.5.3.load = load i64, ptr %sunkaddr251, align 8
  %sunkaddr252 = getelementptr inbounds i8, ptr %.990, i64 512
  %.1087.fca.0.0.3.5.4.load = load ptr, ptr %sunkaddr252, align 8
  %sunkaddr253 = getelementptr inbounds i8, ptr %.990, i64 520
  %.1087.fca.0.0.3.5.5.0.load = load i64, ptr %sunkaddr253, align 8
  %sunkaddr254 = getelementptr inbounds i8, ptr %.990, i64 528
  %.1087.fca.0.0.3.5.6.0.load = load i64, ptr %sunkaddr254, align 8
  %sunkaddr255 = getelementptr inbounds i8, ptr %.990, i64 536
  %.1087.fca.0.1.0.load = load ptr, ptr %sunkaddr255, align 8
  %sunkaddr256 = getelementptr inbounds i8, ptr %.990, i64 544
  %.1087.fca.0.1.1.load = load ptr, ptr %sunkaddr256, align 8
  %sunkaddr257 = getelementptr inbounds i8, ptr %.990, i64 552
  %.1087.fca.0.1.2.load = load i64, ptr %sunkaddr257, align 8
  %sunkaddr258 = getelementptr inbounds i8, ptr %.990, i64 560
  %.1087.fca.0.1.3.load = load i64, ptr %sunkaddr258, align 8
  %sunkaddr259 = getelementptr inbounds i8, ptr %.990, i64 568
  %.1087.fca.0.1.4.load = load ptr, ptr %sunkaddr259, align 8
  %sunkaddr260 = getelementptr inbounds i8, ptr %.990, i64 576
  %.1087.fca.0.1.5.0.load = load i64, ptr %sunkaddr260, align 8
  %sunkaddr261 = getelementptr inbounds i8, ptr %.990, i64 584
  %.1087.fca.0.1.5.1.load = load i64, ptr %sunkaddr261, align 8
  %sunkaddr262 = getelementptr inbounds i8, ptr %.990, i64 592
  %.1087.fca.0.1.6.0.load = load i64, ptr %sunkaddr262, align 8
  %sunkaddr263 = getelementptr inbounds i8, ptr %.990, i64 600
  %.1087.fca.0.1.6.1.load = load i64, ptr %sunkaddr263, align 8
  %sunkaddr264 = getelementptr inbounds i8, ptr %.990, i64 608
  %.1087.fca.0.2.0.load = load ptr, ptr %sunkaddr264, align 8
  %sunkaddr265 = getelementptr inbounds i8, ptr %.990, i64 616
  %.1087.fca.0.2.1.load = load ptr, ptr %sunkaddr265, align 8
  %sunkaddr266 = getelementptr inbounds i8, ptr %.990, i64 624
  %.1087.fca.0.2.2.load = load i64, ptr %sunkaddr266, align 8
  %sunkaddr267 = getelementptr inbounds i8, ptr %.990, i64 632
  %.1087.fca.0.2.3.load = load i64, ptr %sunkaddr267, align 8
  %sunkaddr268 = getelementptr inbounds i8, ptr %.990, i64 640
  %.1087.fca.0.2.4.load = load ptr, ptr %sunkaddr268, align 8
  %sunkaddr269 = getelementptr inbounds i8, ptr %.990, i64 648
  %.1087.fca.0.2.5.0.load = load i64, ptr %sunkaddr269, align 8
  %sunkaddr270 = getelementptr inbounds i8, ptr %.990, i64 656
  %.1087.fca.0.2.5.1.load = load i64, ptr %sunkaddr270, align 8
  %sunkaddr271 = getelementptr inbounds i8, ptr %.990, i64 664
  %.1087.fca.0.2.6.0.load = load i64, ptr %sunkaddr271, align 8
  %sunkaddr272 = getelementptr inbounds i8, ptr %.990, i64 672
  %.1087.fca.0.2.6.1.load = load i64, ptr %sunkaddr272, align 8
  %sunkaddr273 = getelementptr inbounds i8, ptr %.990, i64 680
  %.1087.fca.0.3.load = load double, ptr %sunkaddr273, align 8
  %sunkaddr274 = getelementptr inbounds i8, ptr %.990, i64 688
  %.1087.fca.1.load = load i64, ptr %sunkaddr274, align 8
  call void @PyEval_RestoreThread(ptr %.989)
  call void @NRT_decref(ptr %.68.fca.0.load)
  call void @NRT_decref(ptr %.88.fca.0.load)
  call void @NRT_decref(ptr %.166.fca.0.load)
  call void @NRT_decref(ptr %.186.fca.0.load)
  call void @NRT_decref(ptr %.206.fca.0.load)
  call void @NRT_decref(ptr %.226.fca.0.load)
  call void @NRT_decref(ptr %.246.fca.0.load)
  call void @NRT_decref(ptr %.266.fca.0.load)
  call void @NRT_decref(ptr %.286.fca.0.load)
  call void @NRT_decref(ptr %.370.fca.0.load)
  call void @NRT_decref(ptr %.390.fca.0.load)
  call void @NRT_decref(ptr %.410.fca.0.load)
  call void @NRT_decref(ptr %.443.fca.0.load)
  call void @NRT_decref(ptr %.463.fca.0.load)
  call void @NRT_decref(ptr %.483.fca.0.load)
  call void @NRT_decref(ptr %.503.fca.0.load)
  call void @NRT_decref(ptr %.523.fca.0.load)
  call void @NRT_decref(ptr %.543.fca.0.load)
  call void @NRT_decref(ptr %.585.fca.0.load)
  call void @NRT_decref(ptr %.605.fca.0.load)
  call void @NRT_decref(ptr %.701.fca.0.load)
  call void @NRT_decref(ptr %.724.fca.0.load)
  call void @NRT_decref(ptr %.747.fca.0.load)
  call void @NRT_decref(ptr %.783.fca.0.load)
  call void @NRT_decref(ptr %.803.fca.0.load)
  call void @NRT_decref(ptr %.823.fca.0.load)
  call void @NRT_decref(ptr %.843.fca.0.load)
  call void @NRT_decref(ptr %.863.fca.0.load)
  call void @NRT_decref(ptr %.883.fca.0.load)
  call void @NRT_decref(ptr %.903.fca.0.load)
  call void @NRT_decref(ptr %.923.fca.0.load)
  %cond = icmp eq i32 %.1077, 0
  br i1 %cond, label %entry.endif.endif.endif.e...endif.20, label %entry.endif.endif.endif.e...endif.19.endif.endif.endif, !prof !0

entry.endif.endif.endif.e...endif.19.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.19.endif.endif
  %.1085 = icmp sgt i32 %.1077, 0
  br i1 %.1085, label %entry.endif.endif.endif.e...if.23, label %entry.endif.endif.endif.e...endif.23

entry.endif.endif.endif.e...endif.20:             ; preds = %entry.endif.endif.endif.e...endif.19.endif.endif
  %.1360 = call ptr @PyTuple_New(i64 2)
  %.1368 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.a3f35a65b9e37846edcc099731c801853500822c, i32 78, ptr nonnull @.const.pickledata.a3f35a65b9e37846edcc099731c801853500822c.sha1)
  %.1369 = call ptr @PyTuple_New(i64 4)
  %.1377 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.1e8642808d94220167a3f7d7bcccdb722eecb5ad, i32 78, ptr nonnull @.const.pickledata.1e8642808d94220167a3f7d7bcccdb722eecb5ad.sha1)
  %.1378 = call ptr @PyTuple_New(i64 4)
  %.1384 = getelementptr i8, ptr %.23, i64 24
  %.1385 = load ptr, ptr %.1384, align 8
  %.1389.not = icmp eq ptr %.1385, null
  br i1 %.1389.not, label %entry.endif.endif.endif.e...endif.20.else, label %entry.endif.endif.endif.e...endif.20.if

entry.endif.endif.endif.e...endif.20.if:          ; preds = %entry.endif.endif.endif.e...endif.20
  %.1391 = call ptr @PyList_GetItem(ptr nonnull %.1385, i64 0)
  br label %entry.endif.endif.endif.e...endif.20.endif

entry.endif.endif.endif.e...endif.20.else:        ; preds = %entry.endif.endif.endif.e...endif.20
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.`env.consts` is NULL in `read_const`")
  br label %entry.endif.endif.endif.e...endif.20.endif

entry.endif.endif.endif.e...endif.20.endif:       ; preds = %entry.endif.endif.endif.e...endif.20.else, %entry.endif.endif.endif.e...endif.20.if
  %.1386.0 = phi ptr [ %.1391, %entry.endif.endif.endif.e...endif.20.if ], [ null, %entry.endif.endif.endif.e...endif.20.else ]
  %.1403 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3, i32 32, ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1)
  store ptr %.1087.fca.0.0.0.0.load, ptr %.1404, align 8
  %sunkaddr275 = getelementptr inbounds i8, ptr %.1404, i64 8
  store ptr %.1087.fca.0.0.0.1.load, ptr %sunkaddr275, align 8
  %sunkaddr276 = getelementptr inbounds i8, ptr %.1404, i64 16
  store i64 %.1087.fca.0.0.0.2.load, ptr %sunkaddr276, align 8
  %sunkaddr277 = getelementptr inbounds i8, ptr %.1404, i64 24
  store i64 %.1087.fca.0.0.0.3.load, ptr %sunkaddr277, align 8
  %sunkaddr278 = getelementptr inbounds i8, ptr %.1404, i64 32
  store ptr %.1087.fca.0.0.0.4.load, ptr %sunkaddr278, align 8
  %sunkaddr279 = getelementptr inbounds i8, ptr %.1404, i64 40
  store i64 %.1087.fca.0.0.0.5.0.load, ptr %sunkaddr279, align 8
  %sunkaddr280 = getelementptr inbounds i8, ptr %.1404, i64 48
  store i64 %.1087.fca.0.0.0.5.1.load, ptr %sunkaddr280, align 8
  %sunkaddr281 = getelementptr inbounds i8, ptr %.1404, i64 56
  store i64 %.1087.fca.0.0.0.5.2.load, ptr %sunkaddr281, align 8
  %sunkaddr282 = getelementptr inbounds i8, ptr %.1404, i64 64
  store i64 %.1087.fca.0.0.0.6.0.load, ptr %sunkaddr282, align 8
  %sunkaddr283 = getelementptr inbounds i8, ptr %.1404, i64 72
  store i64 %.1087.fca.0.0.0.6.1.load, ptr %sunkaddr283, align 8
  %sunkaddr284 = getelementptr inbounds i8, ptr %.1404, i64 80
  store i64 %.1087.fca.0.0.0.6.2.load, ptr %sunkaddr284, align 8
  %.1408 = call ptr @NRT_adapt_ndarray_to_python_acqref(ptr nonnull %.1404, ptr %.1403, i32 3, i32 1, ptr %.1386.0)
  call void @NRT_decref(ptr %.1087.fca.0.0.0.0.load)
  %.1416 = call i32 @PyTuple_SetItem(ptr %.1378, i64 0, ptr %.1408)
  %sunkaddr285 = getelementptr i8, ptr %.23, i64 24
  %.1423 = load ptr, ptr %sunkaddr285, align 8
  %.1427.not = icmp eq ptr %.1423, null
  br i1 %.1427.not, label %entry.endif.endif.endif.e...endif.20.endif.else, label %entry.endif.endif.endif.e...endif.20.endif.if

entry.endif.endif.endif.e...endif.20.endif.if:    ; preds = %entry.endif.endif.endif.e...endif.20.endif
  %.1429 = call ptr @PyList_GetItem(ptr nonnull %.1423, i64 1)
  br label %entry.endif.endif.endif.e...endif.20.endif.endif

entry.endif.endif.endif.e...endif.20.endif.else:  ; preds = %entry.endif.endif.endif.e...endif.20.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.`env.consts` is NULL in `read_const`")
  br label %entry.endif.endif.endif.e...endif.20.endif.endif

entry.endif.endif.endif.e...endif.20.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.20.endif.else, %entry.endif.endif.endif.e...endif.20.endif.if
  %.1424.0 = phi ptr [ %.1429, %entry.endif.endif.endif.e...endif.20.endif.if ], [ null, %entry.endif.endif.endif.e...endif.20.endif.else ]
  %.1441 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3, i32 32, ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1)
  store ptr %.1087.fca.0.0.1.0.load, ptr %.1442, align 8
  %sunkaddr286 = getelementptr inbounds i8, ptr %.1442, i64 8
  store ptr %.1087.fca.0.0.1.1.load, ptr %sunkaddr286, align 8
  %sunkaddr287 = getelementptr inbounds i8, ptr %.1442, i64 16
  store i64 %.1087.fca.0.0.1.2.load, ptr %sunkaddr287, align 8
  %sunkaddr288 = getelementptr inbounds i8, ptr %.1442, i64 24
  store i64 %.1087.fca.0.0.1.3.load, ptr %sunkaddr288, align 8
  %sunkaddr289 = getelementptr inbounds i8, ptr %.1442, i64 32
  store ptr %.1087.fca.0.0.1.4.load, ptr %sunkaddr289, align 8
  %sunkaddr290 = getelementptr inbounds i8, ptr %.1442, i64 40
  store i64 %.1087.fca.0.0.1.5.0.load, ptr %sunkaddr290, align 8
  %sunkaddr291 = getelementptr inbounds i8, ptr %.1442, i64 48
  store i64 %.1087.fca.0.0.1.6.0.load, ptr %sunkaddr291, align 8
  %.1446 = call ptr @NRT_adapt_ndarray_to_python_acqref(ptr nonnull %.1442, ptr %.1441, i32 1, i32 1, ptr %.1424.0)
  call void @NRT_decref(ptr %.1087.fca.0.0.1.0.load)
  %.1450 = call i32 @PyTuple_SetItem(ptr %.1378, i64 1, ptr %.1446)
  %sunkaddr292 = getelementptr i8, ptr %.23, i64 24
  %.1457 = load ptr, ptr %sunkaddr292, align 8
  %.1461.not = icmp eq ptr %.1457, null
  br i1 %.1461.not, label %entry.endif.endif.endif.e...endif.20.endif.endif.else, label %entry.endif.endif.endif.e...endif.20.endif.endif.if

entry.endif.endif.endif.e...endif.20.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.20.endif.endif
  %.1463 = call ptr @PyList_GetItem(ptr nonnull %.1457, i64 1)
  br label %entry.endif.endif.endif.e...endif.20.endif.endif.endif

entry.endif.endif.endif.e...endif.20.endif.endif.else: ; preds = %entry.endif.endif.endif.e...endif.20.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.`env.consts` is NULL in `read_const`")
  br label %entry.endif.endif.endif.e...endif.20.endif.endif.endif

entry.endif.endif.endif.e...endif.20.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.20.endif.endif.else, %entry.endif.endif.endif.e...endif.20.endif.endif.if
  %.1458.0 = phi ptr [ %.1463, %entry.endif.endif.endif.e...endif.20.endif.endif.if ], [ null, %entry.endif.endif.endif.e...endif.20.endif.endif.else ]
  %.1475 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3, i32 32, ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1)
  store ptr %.1087.fca.0.0.2.0.load, ptr %.1476, align 8
  %sunkaddr293 = getelementptr inbounds i8, ptr %.1476, i64 8
  store ptr %.1087.fca.0.0.2.1.load, ptr %sunkaddr293, align 8
  %sunkaddr294 = getelementptr inbounds i8, ptr %.1476, i64 16
  store i64 %.1087.fca.0.0.2.2.load, ptr %sunkaddr294, align 8
  %sunkaddr295 = getelementptr inbounds i8, ptr %.1476, i64 24
  store i64 %.1087.fca.0.0.2.3.load, ptr %sunkaddr295, align 8
  %sunkaddr296 = getelementptr inbounds i8, ptr %.1476, i64 32
  store ptr %.1087.fca.0.0.2.4.load, ptr %sunkaddr296, align 8
  %sunkaddr297 = getelementptr inbounds i8, ptr %.1476, i64 40
  store i64 %.1087.fca.0.0.2.5.0.load, ptr %sunkaddr297, align 8
  %sunkaddr298 = getelementptr inbounds i8, ptr %.1476, i64 48
  store i64 %.1087.fca.0.0.2.6.0.load, ptr %sunkaddr298, align 8
  %.1480 = call ptr @NRT_adapt_ndarray_to_python_acqref(ptr nonnull %.1476, ptr %.1475, i32 1, i32 1, ptr %.1458.0)
  call void @NRT_decref(ptr %.1087.fca.0.0.2.0.load)
  %.1484 = call i32 @PyTuple_SetItem(ptr %.1378, i64 2, ptr %.1480)
  %.1492 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.043d37c924107a8e462ba1f317a63b2e2f59065c, i32 68, ptr nonnull @.const.pickledata.043d37c924107a8e462ba1f317a63b2e2f59065c.sha1)
  %.1493 = call ptr @PyTuple_New(i64 6)
  %sunkaddr299 = getelementptr i8, ptr %.23, i64 24
  %.1500 = load ptr, ptr %sunkaddr299, align 8
  %.1504.not = icmp eq ptr %.1500, null
  br i1 %.1504.not, label %entry.endif.endif.endif.e...else, label %entry.endif.endif.endif.e...if.21

entry.endif.endif.endif.e...if.21:                ; preds = %entry.endif.endif.endif.e...endif.20.endif.endif.endif
  %.1506 = call ptr @PyList_GetItem(ptr nonnull %.1500, i64 0)
  br label %entry.endif.endif.endif.e...endif.21

entry.endif.endif.endif.e...else:                 ; preds = %entry.endif.endif.endif.e...endif.20.endif.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.`env.consts` is NULL in `read_const`")
  br label %entry.endif.endif.endif.e...endif.21

entry.endif.endif.endif.e...endif.21:             ; preds = %entry.endif.endif.endif.e...else, %entry.endif.endif.endif.e...if.21
  %.1501.0 = phi ptr [ %.1506, %entry.endif.endif.endif.e...if.21 ], [ null, %entry.endif.endif.endif.e...else ]
  %.1518 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3, i32 32, ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1)
  store ptr %.1087.fca.0.0.3.0.0.load, ptr %.1519, align 8
  %sunkaddr300 = getelementptr inbounds i8, ptr %.1519, i64 8
  store ptr %.1087.fca.0.0.3.0.1.load, ptr %sunkaddr300, align 8
  %sunkaddr301 = getelementptr inbounds i8, ptr %.1519, i64 16
  store i64 %.1087.fca.0.0.3.0.2.load, ptr %sunkaddr301, align 8
  %sunkaddr302 = getelementptr inbounds i8, ptr %.1519, i64 24
  store i64 %.1087.fca.0.0.3.0.3.load, ptr %sunkaddr302, align 8
  %sunkaddr303 = getelementptr inbounds i8, ptr %.1519, i64 32
  store ptr %.1087.fca.0.0.3.0.4.load, ptr %sunkaddr303, align 8
  %sunkaddr304 = getelementptr inbounds i8, ptr %.1519, i64 40
  store i64 %.1087.fca.0.0.3.0.5.0.load, ptr %sunkaddr304, align 8
  %sunkaddr305 = getelementptr inbounds i8, ptr %.1519, i64 48
  store i64 %.1087.fca.0.0.3.0.6.0.load, ptr %sunkaddr305, align 8
  %.1523 = call ptr @NRT_adapt_ndarray_to_python_acqref(ptr nonnull %.1519, ptr %.1518, i32 1, i32 1, ptr %.1501.0)
  call void @NRT_decref(ptr %.1087.fca.0.0.3.0.0.load)
  %.1527 = call i32 @PyTuple_SetItem(ptr %.1493, i64 0, ptr %.1523)
  %sunkaddr306 = getelementptr i8, ptr %.23, i64 24
  %.1534 = load ptr, ptr %sunkaddr306, align 8
  %.1538.not = icmp eq ptr %.1534, null
  br i1 %.1538.not, label %entry.endif.endif.endif.e...endif.21.else, label %entry.endif.endif.endif.e...endif.21.if

entry.endif.endif.endif.e...endif.21.if:          ; preds = %entry.endif.endif.endif.e...endif.21
  %.1540 = call ptr @PyList_GetItem(ptr nonnull %.1534, i64 1)
  br label %entry.endif.endif.endif.e...endif.21.endif

entry.endif.endif.endif.e...endif.21.else:        ; preds = %entry.endif.endif.endif.e...endif.21
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.`env.consts` is NULL in `read_const`")
  br label %entry.endif.endif.endif.e...endif.21.endif

entry.endif.endif.endif.e...endif.21.endif:       ; preds = %entry.endif.endif.endif.e...endif.21.else, %entry.endif.endif.endif.e...endif.21.if
  %.1535.0 = phi ptr [ %.1540, %entry.endif.endif.endif.e...endif.21.if ], [ null, %entry.endif.endif.endif.e...endif.21.else ]
  %.1552 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3, i32 32, ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1)
  store ptr %.1087.fca.0.0.3.1.0.load, ptr %.1553, align 8
  %sunkaddr307 = getelementptr inbounds i8, ptr %.1553, i64 8
  store ptr %.1087.fca.0.0.3.1.1.load, ptr %sunkaddr307, align 8
  %sunkaddr308 = getelementptr inbounds i8, ptr %.1553, i64 16
  store i64 %.1087.fca.0.0.3.1.2.load, ptr %sunkaddr308, align 8
  %sunkaddr309 = getelementptr inbounds i8, ptr %.1553, i64 24
  store i64 %.1087.fca.0.0.3.1.3.load, ptr %sunkaddr309, align 8
  %sunkaddr310 = getelementptr inbounds i8, ptr %.1553, i64 32
  store ptr %.1087.fca.0.0.3.1.4.load, ptr %sunkaddr310, align 8
  %sunkaddr311 = getelementptr inbounds i8, ptr %.1553, i64 40
  store i64 %.1087.fca.0.0.3.1.5.0.load, ptr %sunkaddr311, align 8
  %sunkaddr312 = getelementptr inbounds i8, ptr %.1553, i64 48
  store i64 %.1087.fca.0.0.3.1.6.0.load, ptr %sunkaddr312, align 8
  %.1557 = call ptr @NRT_adapt_ndarray_to_python_acqref(ptr nonnull %.1553, ptr %.1552, i32 1, i32 1, ptr %.1535.0)
  call void @NRT_decref(ptr %.1087.fca.0.0.3.1.0.load)
  %.1561 = call i32 @PyTuple_SetItem(ptr %.1493, i64 1, ptr %.1557)
  %sunkaddr313 = getelementptr i8, ptr %.23, i64 24
  %.1568 = load ptr, ptr %sunkaddr313, align 8
  %.1572.not = icmp eq ptr %.1568, null
  br i1 %.1572.not, label %entry.endif.endif.endif.e...endif.21.endif.else, label %entry.endif.endif.endif.e...endif.21.endif.if

entry.endif.endif.endif.e...endif.21.endif.if:    ; preds = %entry.endif.endif.endif.e...endif.21.endif
  %.1574 = call ptr @PyList_GetItem(ptr nonnull %.1568, i64 1)
  br label %entry.endif.endif.endif.e...endif.21.endif.endif

entry.endif.endif.endif.e...endif.21.endif.else:  ; preds = %entry.endif.endif.endif.e...endif.21.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.`env.consts` is NULL in `read_const`")
  br label %entry.endif.endif.endif.e...endif.21.endif.endif

entry.endif.endif.endif.e...endif.21.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.21.endif.else, %entry.endif.endif.endif.e...endif.21.endif.if
  %.1569.0 = phi ptr [ %.1574, %entry.endif.endif.endif.e...endif.21.endif.if ], [ null, %entry.endif.endif.endif.e...endif.21.endif.else ]
  %.1586 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3, i32 32, ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1)
  store ptr %.1087.fca.0.0.3.2.0.load, ptr %.1587, align 8
  %sunkaddr314 = getelementptr inbounds i8, ptr %.1587, i64 8
  store ptr %.1087.fca.0.0.3.2.1.load, ptr %sunkaddr314, align 8
  %sunkaddr315 = getelementptr inbounds i8, ptr %.1587, i64 16
  store i64 %.1087.fca.0.0.3.2.2.load, ptr %sunkaddr315, align 8
  %sunkaddr316 = getelementptr inbounds i8, ptr %.1587, i64 24
  store i64 %.1087.fca.0.0.3.2.3.load, ptr %sunkaddr316, align 8
  %sunkaddr317 = getelementptr inbounds i8, ptr %.1587, i64 32
  store ptr %.1087.fca.0.0.3.2.4.load, ptr %sunkaddr317, align 8
  %sunkaddr318 = getelementptr inbounds i8, ptr %.1587, i64 40
  store i64 %.1087.fca.0.0.3.2.5.0.load, ptr %sunkaddr318, align 8
  %sunkaddr319 = getelementptr inbounds i8, ptr %.1587, i64 48
  store i64 %.1087.fca.0.0.3.2.6.0.load, ptr %sunkaddr319, align 8
  %.1591 = call ptr @NRT_adapt_ndarray_to_python_acqref(ptr nonnull %.1587, ptr %.1586, i32 1, i32 1, ptr %.1569.0)
  call void @NRT_decref(ptr %.1087.fca.0.0.3.2.0.load)
  %.1595 = call i32 @PyTuple_SetItem(ptr %.1493, i64 2, ptr %.1591)
  %sunkaddr320 = getelementptr i8, ptr %.23, i64 24
  %.1602 = load ptr, ptr %sunkaddr320, align 8
  %.1606.not = icmp eq ptr %.1602, null
  br i1 %.1606.not, label %entry.endif.endif.endif.e...endif.21.endif.endif.else, label %entry.endif.endif.endif.e...endif.21.endif.endif.if

entry.endif.endif.endif.e...endif.21.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.21.endif.endif
  %.1608 = call ptr @PyList_GetItem(ptr nonnull %.1602, i64 0)
  br label %entry.endif.endif.endif.e...endif.21.endif.endif.endif

entry.endif.endif.endif.e...endif.21.endif.endif.else: ; preds = %entry.endif.endif.endif.e...endif.21.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.`env.consts` is NULL in `read_const`")
  br label %entry.endif.endif.endif.e...endif.21.endif.endif.endif

entry.endif.endif.endif.e...endif.21.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.21.endif.endif.else, %entry.endif.endif.endif.e...endif.21.endif.endif.if
  %.1603.0 = phi ptr [ %.1608, %entry.endif.endif.endif.e...endif.21.endif.endif.if ], [ null, %entry.endif.endif.endif.e...endif.21.endif.endif.else ]
  %.1620 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3, i32 32, ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1)
  store ptr %.1087.fca.0.0.3.3.0.load, ptr %.1621, align 8
  %sunkaddr321 = getelementptr inbounds i8, ptr %.1621, i64 8
  store ptr %.1087.fca.0.0.3.3.1.load, ptr %sunkaddr321, align 8
  %sunkaddr322 = getelementptr inbounds i8, ptr %.1621, i64 16
  store i64 %.1087.fca.0.0.3.3.2.load, ptr %sunkaddr322, align 8
  %sunkaddr323 = getelementptr inbounds i8, ptr %.1621, i64 24
  store i64 %.1087.fca.0.0.3.3.3.load, ptr %sunkaddr323, align 8
  %sunkaddr324 = getelementptr inbounds i8, ptr %.1621, i64 32
  store ptr %.1087.fca.0.0.3.3.4.load, ptr %sunkaddr324, align 8
  %sunkaddr325 = getelementptr inbounds i8, ptr %.1621, i64 40
  store i64 %.1087.fca.0.0.3.3.5.0.load, ptr %sunkaddr325, align 8
  %sunkaddr326 = getelementptr inbounds i8, ptr %.1621, i64 48
  store i64 %.1087.fca.0.0.3.3.6.0.load, ptr %sunkaddr326, align 8
  %.1625 = call ptr @NRT_adapt_ndarray_to_python_acqref(ptr nonnull %.1621, ptr %.1620, i32 1, i32 1, ptr %.1603.0)
  call void @NRT_decref(ptr %.1087.fca.0.0.3.3.0.load)
  %.1629 = call i32 @PyTuple_SetItem(ptr %.1493, i64 3, ptr %.1625)
  %sunkaddr327 = getelementptr i8, ptr %.23, i64 24
  %.1636 = load ptr, ptr %sunkaddr327, align 8
  %.1640.not = icmp eq ptr %.1636, null
  br i1 %.1640.not, label %entry.endif.endif.endif.e...else.1, label %entry.endif.endif.endif.e...if.22

entry.endif.endif.endif.e...if.22:                ; preds = %entry.endif.endif.endif.e...endif.21.endif.endif.endif
  %.1642 = call ptr @PyList_GetItem(ptr nonnull %.1636, i64 0)
  br label %entry.endif.endif.endif.e...endif.22

entry.endif.endif.endif.e...else.1:               ; preds = %entry.endif.endif.endif.e...endif.21.endif.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.`env.consts` is NULL in `read_const`")
  br label %entry.endif.endif.endif.e...endif.22

entry.endif.endif.endif.e...endif.22:             ; preds = %entry.endif.endif.endif.e...else.1, %entry.endif.endif.endif.e...if.22
  %.1637.0 = phi ptr [ %.1642, %entry.endif.endif.endif.e...if.22 ], [ null, %entry.endif.endif.endif.e...else.1 ]
  %.1654 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3, i32 32, ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1)
  store ptr %.1087.fca.0.0.3.4.0.load, ptr %.1655, align 8
  %sunkaddr328 = getelementptr inbounds i8, ptr %.1655, i64 8
  store ptr %.1087.fca.0.0.3.4.1.load, ptr %sunkaddr328, align 8
  %sunkaddr329 = getelementptr inbounds i8, ptr %.1655, i64 16
  store i64 %.1087.fca.0.0.3.4.2.load, ptr %sunkaddr329, align 8
  %sunkaddr330 = getelementptr inbounds i8, ptr %.1655, i64 24
  store i64 %.1087.fca.0.0.3.4.3.load, ptr %sunkaddr330, align 8
  %sunkaddr331 = getelementptr inbounds i8, ptr %.1655, i64 32
  store ptr %.1087.fca.0.0.3.4.4.load, ptr %sunkaddr331, align 8
  %sunkaddr332 = getelementptr inbounds i8, ptr %.1655, i64 40
  store i64 %.1087.fca.0.0.3.4.5.0.load, ptr %sunkaddr332, align 8
  %sunkaddr333 = getelementptr inbounds i8, ptr %.1655, i64 48
  store i64 %.1087.fca.0.0.3.4.6.0.load, ptr %sunkaddr333, align 8
  %.1659 = call ptr @NRT_adapt_ndarray_to_python_acqref(ptr nonnull %.1655, ptr %.1654, i32 1, i32 1, ptr %.1637.0)
  call void @NRT_decref(ptr %.1087.fca.0.0.3.4.0.load)
  %.1663 = call i32 @PyTuple_SetItem(ptr %.1493, i64 4, ptr %.1659)
  %sunkaddr334 = getelementptr i8, ptr %.23, i64 24
  %.1670 = load ptr, ptr %sunkaddr334, align 8
  %.1674.not = icmp eq ptr %.1670, null
  br i1 %.1674.not, label %entry.endif.endif.endif.e...endif.22.else, label %entry.endif.endif.endif.e...endif.22.if

entry.endif.endif.endif.e...endif.22.if:          ; preds = %entry.endif.endif.endif.e...endif.22
  %.1676 = call ptr @PyList_GetItem(ptr nonnull %.1670, i64 0)
  br label %entry.endif.endif.endif.e...endif.22.endif

entry.endif.endif.endif.e...endif.22.else:        ; preds = %entry.endif.endif.endif.e...endif.22
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.`env.consts` is NULL in `read_const`")
  br label %entry.endif.endif.endif.e...endif.22.endif

entry.endif.endif.endif.e...endif.22.endif:       ; preds = %entry.endif.endif.endif.e...endif.22.else, %entry.endif.endif.endif.e...endif.22.if
  %.1671.0 = phi ptr [ %.1676, %entry.endif.endif.endif.e...endif.22.if ], [ null, %entry.endif.endif.endif.e...endif.22.else ]
  %.1688 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3, i32 32, ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1)
  store ptr %.1087.fca.0.0.3.5.0.load, ptr %.1689, align 8
  %sunkaddr335 = getelementptr inbounds i8, ptr %.1689, i64 8
  store ptr %.1087.fca.0.0.3.5.1.load, ptr %sunkaddr335, align 8
  %sunkaddr336 = getelementptr inbounds i8, ptr %.1689, i64 16
  store i64 %.1087.fca.0.0.3.5.2.load, ptr %sunkaddr336, align 8
  %sunkaddr337 = getelementptr inbounds i8, ptr %.1689, i64 24
  store i64 %.1087.fca.0.0.3.5.3.load, ptr %sunkaddr337, align 8
  %sunkaddr338 = getelementptr inbounds i8, ptr %.1689, i64 32
  store ptr %.1087.fca.0.0.3.5.4.load, ptr %sunkaddr338, align 8
  %sunkaddr339 = getelementptr inbounds i8, ptr %.1689, i64 40
  store i64 %.1087.fca.0.0.3.5.5.0.load, ptr %sunkaddr339, align 8
  %sunkaddr340 = getelementptr inbounds i8, ptr %.1689, i64 48
  store i64 %.1087.fca.0.0.3.5.6.0.load, ptr %sunkaddr340, align 8
  %.1693 = call ptr @NRT_adapt_ndarray_to_python_acqref(ptr nonnull %.1689, ptr %.1688, i32 1, i32 1, ptr %.1671.0)
  call void @NRT_decref(ptr %.1087.fca.0.0.3.5.0.load)
  %.1697 = call i32 @PyTuple_SetItem(ptr %.1493, i64 5, ptr %.1693)
  %.1698 = call ptr @PyObject_Call(ptr %.1492, ptr %.1493, ptr null)
  call void @Py_DecRef(ptr %.1492)
  call void @Py_DecRef(ptr %.1493)
  %.1701 = call i32 @PyTuple_SetItem(ptr %.1378, i64 3, ptr %.1698)
  %.1702 = call ptr @PyObject_Call(ptr %.1377, ptr %.1378, ptr null)
  call void @Py_DecRef(ptr %.1377)
  call void @Py_DecRef(ptr %.1378)
  %.1705 = call i32 @PyTuple_SetItem(ptr %.1369, i64 0, ptr %.1702)
  %sunkaddr341 = getelementptr i8, ptr %.23, i64 24
  %.1712 = load ptr, ptr %sunkaddr341, align 8
  %.1716.not = icmp eq ptr %.1712, null
  br i1 %.1716.not, label %entry.endif.endif.endif.e...endif.22.endif.else, label %entry.endif.endif.endif.e...endif.22.endif.if

entry.endif.endif.endif.e...endif.22.endif.if:    ; preds = %entry.endif.endif.endif.e...endif.22.endif
  %.1718 = call ptr @PyList_GetItem(ptr nonnull %.1712, i64 0)
  br label %entry.endif.endif.endif.e...endif.22.endif.endif

entry.endif.endif.endif.e...endif.22.endif.else:  ; preds = %entry.endif.endif.endif.e...endif.22.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.`env.consts` is NULL in `read_const`")
  br label %entry.endif.endif.endif.e...endif.22.endif.endif

entry.endif.endif.endif.e...endif.22.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.22.endif.else, %entry.endif.endif.endif.e...endif.22.endif.if
  %.1713.0 = phi ptr [ %.1718, %entry.endif.endif.endif.e...endif.22.endif.if ], [ null, %entry.endif.endif.endif.e...endif.22.endif.else ]
  %.1730 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3, i32 32, ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1)
  store ptr %.1087.fca.0.1.0.load, ptr %.1731, align 8
  %sunkaddr342 = getelementptr inbounds i8, ptr %.1731, i64 8
  store ptr %.1087.fca.0.1.1.load, ptr %sunkaddr342, align 8
  %sunkaddr343 = getelementptr inbounds i8, ptr %.1731, i64 16
  store i64 %.1087.fca.0.1.2.load, ptr %sunkaddr343, align 8
  %sunkaddr344 = getelementptr inbounds i8, ptr %.1731, i64 24
  store i64 %.1087.fca.0.1.3.load, ptr %sunkaddr344, align 8
  %sunkaddr345 = getelementptr inbounds i8, ptr %.1731, i64 32
  store ptr %.1087.fca.0.1.4.load, ptr %sunkaddr345, align 8
  %sunkaddr346 = getelementptr inbounds i8, ptr %.1731, i64 40
  store i64 %.1087.fca.0.1.5.0.load, ptr %sunkaddr346, align 8
  %sunkaddr347 = getelementptr inbounds i8, ptr %.1731, i64 48
  store i64 %.1087.fca.0.1.5.1.load, ptr %sunkaddr347, align 8
  %sunkaddr348 = getelementptr inbounds i8, ptr %.1731, i64 56
  store i64 %.1087.fca.0.1.6.0.load, ptr %sunkaddr348, align 8
  %sunkaddr349 = getelementptr inbounds i8, ptr %.1731, i64 64
  store i64 %.1087.fca.0.1.6.1.load, ptr %sunkaddr349, align 8
  %.1735 = call ptr @NRT_adapt_ndarray_to_python_acqref(ptr nonnull %.1731, ptr %.1730, i32 2, i32 1, ptr %.1713.0)
  call void @NRT_decref(ptr %.1087.fca.0.1.0.load)
  %.1741 = call i32 @PyTuple_SetItem(ptr %.1369, i64 1, ptr %.1735)
  %sunkaddr350 = getelementptr i8, ptr %.23, i64 24
  %.1748 = load ptr, ptr %sunkaddr350, align 8
  %.1752.not = icmp eq ptr %.1748, null
  br i1 %.1752.not, label %entry.endif.endif.endif.e...endif.22.endif.endif.else, label %entry.endif.endif.endif.e...endif.22.endif.endif.if

entry.endif.endif.endif.e...endif.22.endif.endif.if: ; preds = %entry.endif.endif.endif.e...endif.22.endif.endif
  %.1754 = call ptr @PyList_GetItem(ptr nonnull %.1748, i64 0)
  br label %entry.endif.endif.endif.e...endif.22.endif.endif.endif

entry.endif.endif.endif.e...endif.22.endif.endif.else: ; preds = %entry.endif.endif.endif.e...endif.22.endif.endif
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.`env.consts` is NULL in `read_const`")
  br label %entry.endif.endif.endif.e...endif.22.endif.endif.endif

entry.endif.endif.endif.e...endif.22.endif.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.22.endif.endif.else, %entry.endif.endif.endif.e...endif.22.endif.endif.if
  %.1749.0 = phi ptr [ %.1754, %entry.endif.endif.endif.e...endif.22.endif.endif.if ], [ null, %entry.endif.endif.endif.e...endif.22.endif.endif.else ]
  %.1766 = call ptr @numba_unpickle(ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3, i32 32, ptr nonnull @.const.pickledata.dfbcfdd39fcb26f4d0c680954487b8c0b53bb8a3.sha1)
  store ptr %.1087.fca.0.2.0.load, ptr %.1767, align 8
  %sunkaddr351 = getelementptr inbounds i8, ptr %.1767, i64 8
  store ptr %.1087.fca.0.2.1.load, ptr %sunkaddr351, align 8
  %sunkaddr352 = getelementptr inbounds i8, ptr %.1767, i64 16
  store i64 %.1087.fca.0.2.2.load, ptr %sunkaddr352, align 8
  %sunkaddr353 = getelementptr inbounds i8, ptr %.1767, i64 24
  store i64 %.1087.fca.0.2.3.load, ptr %sunkaddr353, align 8
  %sunkaddr354 = getelementptr inbounds i8, ptr %.1767, i64 32
  store ptr %.1087.fca.0.2.4.load, ptr %sunkaddr354, align 8
  %sunkaddr355 = getelementptr inbounds i8, ptr %.1767, i64 40
  store i64 %.1087.fca.0.2.5.0.load, ptr %sunkaddr355, align 8
  %sunkaddr356 = getelementptr inbounds i8, ptr %.1767, i64 48
  store i64 %.1087.fca.0.2.5.1.load, ptr %sunkaddr356, align 8
  %sunkaddr357 = getelementptr inbounds i8, ptr %.1767, i64 56
  store i64 %.1087.fca.0.2.6.0.load, ptr %sunkaddr357, align 8
  %sunkaddr358 = getelementptr inbounds i8, ptr %.1767, i64 64
  store i64 %.1087.fca.0.2.6.1.load, ptr %sunkaddr358, align 8
  %.1771 = call ptr @NRT_adapt_ndarray_to_python_acqref(ptr nonnull %.1767, ptr %.1766, i32 2, i32 1, ptr %.1749.0)
  call void @NRT_decref(ptr %.1087.fca.0.2.0.load)
  %.1777 = call i32 @PyTuple_SetItem(ptr %.1369, i64 2, ptr %.1771)
  %.1779 = call ptr @PyFloat_FromDouble(double %.1087.fca.0.3.load)
  %.1780 = call i32 @PyTuple_SetItem(ptr %.1369, i64 3, ptr %.1779)
  %.1781 = call ptr @PyObject_Call(ptr %.1368, ptr %.1369, ptr null)
  call void @Py_DecRef(ptr %.1368)
  call void @Py_DecRef(ptr %.1369)
  %.1784 = call i32 @PyTuple_SetItem(ptr %.1360, i64 0, ptr %.1781)
  %.1788 = call ptr @PyLong_FromLongLong(i64 %.1087.fca.1.load)
  %.1791 = call i32 @PyTuple_SetItem(ptr %.1360, i64 1, ptr %.1788)
  br label %common.ret

entry.endif.endif.endif.e...if.23:                ; preds = %entry.endif.endif.endif.e...endif.19.endif.endif.endif
  call void @PyErr_Clear()
  %.1796 = load { ptr, i32, ptr, ptr, i32 }, ptr %.1078, align 8
  %.1797 = extractvalue { ptr, i32, ptr, ptr, i32 } %.1796, 4
  %.1798 = icmp sgt i32 %.1797, 0
  %.1801 = extractvalue { ptr, i32, ptr, ptr, i32 } %.1796, 0
  %.1803 = extractvalue { ptr, i32, ptr, ptr, i32 } %.1796, 1
  br i1 %.1798, label %entry.endif.endif.endif.e...if.23.if, label %entry.endif.endif.endif.e...if.23.else

entry.endif.endif.endif.e...endif.23:             ; preds = %entry.endif.endif.endif.e...endif.19.endif.endif.endif
  switch i32 %.1077, label %entry.endif.endif.endif.e...endif.23.endif.endif [
    i32 -3, label %entry.endif.endif.endif.e...endif.23.if
    i32 -1, label %common.ret
  ]

entry.endif.endif.endif.e...if.23.if:             ; preds = %entry.endif.endif.endif.e...if.23
  %.1804 = sext i32 %.1803 to i64
  %.1805 = call ptr @PyBytes_FromStringAndSize(ptr %.1801, i64 %.1804)
  %.1806 = load { ptr, i32, ptr, ptr, i32 }, ptr %.1078, align 8
  %.1807 = extractvalue { ptr, i32, ptr, ptr, i32 } %.1806, 2
  %.1809 = extractvalue { ptr, i32, ptr, ptr, i32 } %.1806, 3
  %.1811 = call ptr %.1809(ptr %.1807)
  %.1812 = icmp eq ptr %.1811, null
  br i1 %.1812, label %entry.endif.endif.endif.e...if.23.if.if, label %entry.endif.endif.endif.e...if.23.if.endif, !prof !11

entry.endif.endif.endif.e...if.23.else:           ; preds = %entry.endif.endif.endif.e...if.23
  %.1825 = extractvalue { ptr, i32, ptr, ptr, i32 } %.1796, 2
  %.1826 = call ptr @numba_unpickle(ptr %.1801, i32 %.1803, ptr %.1825)
  br label %entry.endif.endif.endif.e...if.23.endif

entry.endif.endif.endif.e...if.23.endif:          ; preds = %entry.endif.endif.endif.e...if.23.if.endif, %entry.endif.endif.endif.e...if.23.else
  %.1828 = phi ptr [ %.1816, %entry.endif.endif.endif.e...if.23.if.endif ], [ %.1826, %entry.endif.endif.endif.e...if.23.else ]
  %.1829.not = icmp eq ptr %.1828, null
  br i1 %.1829.not, label %common.ret, label %entry.endif.endif.endif.e...if.23.endif.if, !prof !11

entry.endif.endif.endif.e...if.23.if.if:          ; preds = %entry.endif.endif.endif.e...if.23.if
  call void @PyErr_SetString(ptr nonnull @PyExc_RuntimeError, ptr nonnull @".const.Error creating Python tuple from runtime exception arguments")
  br label %common.ret

entry.endif.endif.endif.e...if.23.if.endif:       ; preds = %entry.endif.endif.endif.e...if.23.if
  %.1816 = call ptr @numba_runtime_build_excinfo_struct(ptr %.1805, ptr nonnull %.1811)
  call void @NRT_Free(ptr nonnull %.1078)
  br label %entry.endif.endif.endif.e...if.23.endif

entry.endif.endif.endif.e...if.23.endif.if:       ; preds = %entry.endif.endif.endif.e...if.23.endif
  call void @numba_do_raise(ptr nonnull %.1828)
  br label %common.ret

entry.endif.endif.endif.e...endif.23.if:          ; preds = %entry.endif.endif.endif.e...endif.23
  call void @PyErr_SetNone(ptr nonnull @PyExc_StopIteration)
  br label %common.ret

entry.endif.endif.endif.e...endif.23.endif.endif: ; preds = %entry.endif.endif.endif.e...endif.23
  call void @PyErr_SetString(ptr nonnull @PyExc_SystemError, ptr nonnull @".const.unknown error when calling native function")
  br label %common.ret
}

declare i32 @PyArg_UnpackTuple(ptr, ptr, i64, i64, ...) local_unnamed_addr

declare void @PyErr_SetString(ptr, ptr) local_unnamed_addr

declare i64 @PyTuple_Size(ptr) local_unnamed_addr

declare void @PyErr_Format(ptr, ptr, ...) local_unnamed_addr

declare ptr @PyTuple_GetItem(ptr, i64) local_unnamed_addr

declare ptr @PyNumber_Float(ptr) local_unnamed_addr

declare double @PyFloat_AsDouble(ptr) local_unnamed_addr

declare void @Py_DecRef(ptr) local_unnamed_addr

declare ptr @PyErr_Occurred() local_unnamed_addr

declare i32 @NRT_adapt_ndarray_from_python(ptr captures(none), ptr captures(none)) local_unnamed_addr

declare ptr @PyNumber_Long(ptr) local_unnamed_addr

declare i64 @PyLong_AsLongLong(ptr) local_unnamed_addr

declare ptr @PyEval_SaveThread() local_unnamed_addr

declare void @PyEval_RestoreThread(ptr) local_unnamed_addr

declare ptr @PyTuple_New(i64) local_unnamed_addr

declare ptr @numba_unpickle(ptr, i32, ptr) local_unnamed_addr

declare ptr @PyList_GetItem(ptr, i64) local_unnamed_addr

declare ptr @NRT_adapt_ndarray_to_python_acqref(ptr captures(none), ptr, i32, i32, ptr) local_unnamed_addr

declare i32 @PyTuple_SetItem(ptr, i64, ptr) local_unnamed_addr

declare ptr @PyObject_Call(ptr, ptr, ptr) local_unnamed_addr

declare ptr @PyFloat_FromDouble(double) local_unnamed_addr

declare ptr @PyLong_FromLongLong(i64) local_unnamed_addr

declare void @PyErr_Clear() local_unnamed_addr

declare ptr @PyBytes_FromStringAndSize(ptr, i64) local_unnamed_addr

declare ptr @numba_runtime_build_excinfo_struct(ptr, ptr) local_unnamed_addr

declare void @NRT_Free(ptr) local_unnamed_addr

declare void @numba_do_raise(ptr) local_unnamed_addr

declare void @PyErr_SetNone(ptr) local_unnamed_addr

define linkonce_odr range(i32 0, 2) i32 @_ZN18elastomer_friction7kernels5scene12march_blocks15room_for_blocksB2v2B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEx(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, i64 %arg.blocks) local_unnamed_addr {
B0:
  %.28.i = icmp slt i64 %arg.blocks, 0
  br i1 %.28.i, label %B0.if.if, label %B0.endif.endif.endif.i, !prof !11

B0.endif.endif.endif.i:                           ; preds = %B0
  %.50.i = shl i64 %arg.blocks, 6
  %.51.i = icmp samesign ugt i64 %arg.blocks, 144115188075855871
  %0 = add i64 %.50.i, -1152921504606846976
  %.56.i = icmp ult i64 %0, -2305843009213693952
  %.57.i = or i1 %.51.i, %.56.i
  br i1 %.57.i, label %B0.if.if, label %B0.endif.endif.endif.endif.endif.i, !prof !11

B0.endif.endif.endif.endif.endif.i:               ; preds = %B0.endif.endif.endif.i
  %.55.i = shl i64 %arg.blocks, 9
  %.7.i.i.i = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.55.i, i32 32), !noalias !17
  %.8.i.i.i = icmp eq ptr %.7.i.i.i, null
  br i1 %.8.i.i.i, label %B0.if.if, label %B0.endif, !prof !11

B0.endif:                                         ; preds = %B0.endif.endif.endif.endif.endif.i
  %.5.i.i = getelementptr i8, ptr %.7.i.i.i, i64 24
  %.6.i.i = load ptr, ptr %.5.i.i, align 8, !noalias !27
  %.7.i.i.i6 = tail call ptr @NRT_MemInfo_alloc_aligned(i64 8, i32 32), !noalias !28
  %.8.i.i.i7 = icmp eq ptr %.7.i.i.i6, null
  br i1 %.8.i.i.i7, label %B0.endif.if.if, label %B0.endif.endif, !prof !11

common.ret:                                       ; preds = %B0.endif.endif.endif.endif.if.if, %B0.endif.endif.endif.endif.endif, %B0.endif.endif.endif.if.if, %B0.endif.endif.if.if, %B0.endif.if.if, %B0.if.if
  %common.ret.op = phi i32 [ 1, %B0.if.if ], [ 1, %B0.endif.if.if ], [ 1, %B0.endif.endif.if.if ], [ 1, %B0.endif.endif.endif.if.if ], [ 0, %B0.endif.endif.endif.endif.endif ], [ 1, %B0.endif.endif.endif.endif.if.if ]
  ret i32 %common.ret.op

B0.if.if:                                         ; preds = %B0.endif.endif.endif.endif.endif.i, %B0.endif.endif.endif.i, %B0
  %excinfo.1.0.ph = phi ptr [ @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209, %B0.endif.endif.endif.endif.endif.i ], [ @.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57, %B0.endif.endif.endif.i ], [ @.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b, %B0 ]
  store ptr %excinfo.1.0.ph, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif:                                   ; preds = %B0.endif
  %.5.i.i8 = getelementptr i8, ptr %.7.i.i.i6, i64 24
  %.6.i.i9 = load ptr, ptr %.5.i.i8, align 8, !noalias !38
  %.7.i.i.i16 = tail call ptr @NRT_MemInfo_alloc_aligned(i64 512, i32 32), !noalias !39
  %.8.i.i.i17 = icmp eq ptr %.7.i.i.i16, null
  br i1 %.8.i.i.i17, label %B0.endif.endif.if.if, label %B0.endif.endif.endif.i30, !prof !11

B0.endif.if.if:                                   ; preds = %B0.endif
  store ptr @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.7, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.i30:                         ; preds = %B0.endif.endif
  %.5.i.i19 = getelementptr i8, ptr %.7.i.i.i16, i64 24
  %.6.i.i20 = load ptr, ptr %.5.i.i19, align 8, !noalias !49
  %.30.i = shl nuw nsw i64 %arg.blocks, 3
  %.7.i.i.i31 = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.30.i, i32 32), !noalias !50
  %.8.i.i.i32 = icmp eq ptr %.7.i.i.i31, null
  br i1 %.8.i.i.i32, label %B0.endif.endif.endif.if.if, label %B0.endif.endif.endif.endif, !prof !11

B0.endif.endif.if.if:                             ; preds = %B0.endif.endif
  store ptr @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.7, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif:                       ; preds = %B0.endif.endif.endif.i30
  %.5.i.i34 = getelementptr i8, ptr %.7.i.i.i31, i64 24
  %.6.i.i35 = load ptr, ptr %.5.i.i34, align 8, !noalias !60
  %.7.i.i.i47 = tail call ptr @NRT_MemInfo_alloc_aligned(i64 1536, i32 32), !noalias !61
  %.8.i.i.i48 = icmp eq ptr %.7.i.i.i47, null
  br i1 %.8.i.i.i48, label %B0.endif.endif.endif.endif.if.if, label %B0.endif.endif.endif.endif.endif, !prof !11

B0.endif.endif.endif.if.if:                       ; preds = %B0.endif.endif.endif.i30
  store ptr @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.18, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif.endif:                 ; preds = %B0.endif.endif.endif.endif
  %.5.i.i50 = getelementptr i8, ptr %.7.i.i.i47, i64 24
  %.6.i.i51 = load ptr, ptr %.5.i.i50, align 8, !noalias !71
  store ptr %.7.i.i.i31, ptr %retptr, align 8
  %retptr.repack74 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store ptr null, ptr %retptr.repack74, align 8
  %retptr.repack76 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store i64 %arg.blocks, ptr %retptr.repack76, align 8
  %retptr.repack78 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store i64 8, ptr %retptr.repack78, align 8
  %retptr.repack80 = getelementptr inbounds nuw i8, ptr %retptr, i64 32
  store ptr %.6.i.i35, ptr %retptr.repack80, align 8
  %retptr.repack82 = getelementptr inbounds nuw i8, ptr %retptr, i64 40
  store i64 %arg.blocks, ptr %retptr.repack82, align 8
  %retptr.repack84 = getelementptr inbounds nuw i8, ptr %retptr, i64 48
  store i64 8, ptr %retptr.repack84, align 8
  %retptr.repack70 = getelementptr inbounds nuw i8, ptr %retptr, i64 56
  store ptr %.7.i.i.i, ptr %retptr.repack70, align 8
  %retptr.repack70.repack90 = getelementptr inbounds nuw i8, ptr %retptr, i64 64
  store ptr null, ptr %retptr.repack70.repack90, align 8
  %retptr.repack70.repack92 = getelementptr inbounds nuw i8, ptr %retptr, i64 72
  store i64 %.50.i, ptr %retptr.repack70.repack92, align 8
  %retptr.repack70.repack94 = getelementptr inbounds nuw i8, ptr %retptr, i64 80
  store i64 8, ptr %retptr.repack70.repack94, align 8
  %retptr.repack70.repack96 = getelementptr inbounds nuw i8, ptr %retptr, i64 88
  store ptr %.6.i.i, ptr %retptr.repack70.repack96, align 8
  %retptr.repack70.repack98 = getelementptr inbounds nuw i8, ptr %retptr, i64 96
  store i64 %arg.blocks, ptr %retptr.repack70.repack98, align 8
  %retptr.repack70.repack98.repack102 = getelementptr inbounds nuw i8, ptr %retptr, i64 104
  store i64 64, ptr %retptr.repack70.repack98.repack102, align 8
  %retptr.repack70.repack100 = getelementptr inbounds nuw i8, ptr %retptr, i64 112
  store i64 512, ptr %retptr.repack70.repack100, align 8
  %retptr.repack70.repack100.repack104 = getelementptr inbounds nuw i8, ptr %retptr, i64 120
  store i64 8, ptr %retptr.repack70.repack100.repack104, align 8
  %retptr.repack70.repack86 = getelementptr inbounds nuw i8, ptr %retptr, i64 128
  store ptr %.7.i.i.i6, ptr %retptr.repack70.repack86, align 8
  %retptr.repack70.repack86.repack106 = getelementptr inbounds nuw i8, ptr %retptr, i64 136
  store ptr null, ptr %retptr.repack70.repack86.repack106, align 8
  %retptr.repack70.repack86.repack108 = getelementptr inbounds nuw i8, ptr %retptr, i64 144
  store i64 1, ptr %retptr.repack70.repack86.repack108, align 8
  %retptr.repack70.repack86.repack110 = getelementptr inbounds nuw i8, ptr %retptr, i64 152
  store i64 8, ptr %retptr.repack70.repack86.repack110, align 8
  %retptr.repack70.repack86.repack112 = getelementptr inbounds nuw i8, ptr %retptr, i64 160
  store ptr %.6.i.i9, ptr %retptr.repack70.repack86.repack112, align 8
  %retptr.repack70.repack86.repack114 = getelementptr inbounds nuw i8, ptr %retptr, i64 168
  store i64 1, ptr %retptr.repack70.repack86.repack114, align 8
  %retptr.repack70.repack86.repack116 = getelementptr inbounds nuw i8, ptr %retptr, i64 176
  store i64 8, ptr %retptr.repack70.repack86.repack116, align 8
  %retptr.repack70.repack88 = getelementptr inbounds nuw i8, ptr %retptr, i64 184
  store ptr %.7.i.i.i16, ptr %retptr.repack70.repack88, align 8
  %retptr.repack70.repack88.repack118 = getelementptr inbounds nuw i8, ptr %retptr, i64 192
  store ptr null, ptr %retptr.repack70.repack88.repack118, align 8
  %retptr.repack70.repack88.repack120 = getelementptr inbounds nuw i8, ptr %retptr, i64 200
  store i64 64, ptr %retptr.repack70.repack88.repack120, align 8
  %retptr.repack70.repack88.repack122 = getelementptr inbounds nuw i8, ptr %retptr, i64 208
  store i64 8, ptr %retptr.repack70.repack88.repack122, align 8
  %retptr.repack70.repack88.repack124 = getelementptr inbounds nuw i8, ptr %retptr, i64 216
  store ptr %.6.i.i20, ptr %retptr.repack70.repack88.repack124, align 8
  %retptr.repack70.repack88.repack126 = getelementptr inbounds nuw i8, ptr %retptr, i64 224
  store i64 64, ptr %retptr.repack70.repack88.repack126, align 8
  %retptr.repack70.repack88.repack128 = getelementptr inbounds nuw i8, ptr %retptr, i64 232
  store i64 8, ptr %retptr.repack70.repack88.repack128, align 8
  %retptr.repack72 = getelementptr inbounds nuw i8, ptr %retptr, i64 240
  store ptr %.7.i.i.i47, ptr %retptr.repack72, align 8
  %retptr.repack72.repack130 = getelementptr inbounds nuw i8, ptr %retptr, i64 248
  store ptr null, ptr %retptr.repack72.repack130, align 8
  %retptr.repack72.repack132 = getelementptr inbounds nuw i8, ptr %retptr, i64 256
  store i64 192, ptr %retptr.repack72.repack132, align 8
  %retptr.repack72.repack134 = getelementptr inbounds nuw i8, ptr %retptr, i64 264
  store i64 8, ptr %retptr.repack72.repack134, align 8
  %retptr.repack72.repack136 = getelementptr inbounds nuw i8, ptr %retptr, i64 272
  store ptr %.6.i.i51, ptr %retptr.repack72.repack136, align 8
  %retptr.repack72.repack138 = getelementptr inbounds nuw i8, ptr %retptr, i64 280
  store i64 192, ptr %retptr.repack72.repack138, align 8
  %retptr.repack72.repack140 = getelementptr inbounds nuw i8, ptr %retptr, i64 288
  store i64 8, ptr %retptr.repack72.repack140, align 8
  br label %common.ret

B0.endif.endif.endif.endif.if.if:                 ; preds = %B0.endif.endif.endif.endif
  store ptr @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.7, ptr %excinfo, align 8
  br label %common.ret
}

declare noalias ptr @NRT_MemInfo_alloc_aligned(i64, i32) local_unnamed_addr

define linkonce_odr range(i32 0, 2) i32 @_ZN18elastomer_friction7kernels5scene12march_blocks7_lowestB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, ptr %arg.z.0, ptr readnone captures(none) %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr readonly captures(none) %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.5.1, i64 %arg.z.6.0, i64 %arg.z.6.1) local_unnamed_addr {
B0.else.if:
  tail call void @NRT_incref(ptr %arg.z.0)
  %.40 = add nsw i64 %arg.z.5.1, 15
  %.48.1 = ashr i64 %.40, 4
  %.15.i.i = icmp slt i64 %.48.1, 0
  br i1 %.15.i.i, label %B0.endif.if.if, label %B0.endif.endif.endif.i.i, !prof !11

B0.endif.endif.endif.i.i:                         ; preds = %B0.else.if
  %.30.i.i = shl nuw nsw i64 %.48.1, 3
  %.7.i.i.i.i = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.30.i.i, i32 32), !noalias !72
  %.8.i.i.i.i = icmp eq ptr %.7.i.i.i.i, null
  br i1 %.8.i.i.i.i, label %B0.endif.if.if, label %B0.endif.endif.i, !prof !11

B120.i:                                           ; preds = %B120.i.preheader, %B120.i
  %.175144146.i = phi i64 [ %.182.i, %B120.i ], [ %.175144146.i.ph, %B120.i.preheader ]
  %.182.i = add nuw nsw i64 %.175144146.i, 1
  %0 = shl i64 %.175144146.i, 3
  %scevgep.i = getelementptr i8, ptr %.6.i.i.i, i64 %0
  store double 0x7FF0000000000000, ptr %scevgep.i, align 8, !noalias !85
  %exitcond.not.i = icmp eq i64 %.48.1, %.182.i
  br i1 %exitcond.not.i, label %B0.endif.endif.endif, label %B120.i, !llvm.loop !86

B0.endif.endif.i:                                 ; preds = %B0.endif.endif.endif.i.i
  %.5.i.i.i = getelementptr i8, ptr %.7.i.i.i.i, i64 24
  %.6.i.i.i = load ptr, ptr %.5.i.i.i, align 8, !noalias !89
  %.169145.not.i = icmp eq i64 %.48.1, 0
  br i1 %.169145.not.i, label %B0.endif.endif.endif, label %iter.check.i

iter.check.i:                                     ; preds = %B0.endif.endif.i
  %min.iters.check.i = icmp samesign ult i64 %.48.1, 4
  br i1 %min.iters.check.i, label %B120.i.preheader, label %vector.main.loop.iter.check.i

B120.i.preheader:                                 ; preds = %vec.epilog.middle.block.i, %vec.epilog.iter.check.i, %iter.check.i
  %.175144146.i.ph = phi i64 [ 0, %iter.check.i ], [ %n.vec.i, %vec.epilog.iter.check.i ], [ %n.vec13.i, %vec.epilog.middle.block.i ]
  br label %B120.i

vector.main.loop.iter.check.i:                    ; preds = %iter.check.i
  %const = bitcast i64 1152921504606846944 to i64
  %min.iters.check11.i = icmp samesign ult i64 %.48.1, 32
  br i1 %min.iters.check11.i, label %vec.epilog.ph.i, label %vector.ph.i

vector.ph.i:                                      ; preds = %vector.main.loop.iter.check.i
  %const112 = bitcast i64 9223372036854775800 to i64
  %const_mat113 = add i64 %const112, -248
  %1 = and i64 %.30.i.i, %const_mat113
  br label %vector.body.i

vector.body.i:                                    ; preds = %vector.body.i, %vector.ph.i
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %vector.body.i ], [ 0, %vector.ph.i ]
  %sunkaddr = getelementptr i8, ptr %.6.i.i.i, i64 %lsr.iv.i
  store <8 x double> splat (double 0x7FF0000000000000), ptr %sunkaddr, align 8, !noalias !85
  %sunkaddr115 = getelementptr i8, ptr %.6.i.i.i, i64 %lsr.iv.i
  %sunkaddr116 = getelementptr i8, ptr %sunkaddr115, i64 64
  store <8 x double> splat (double 0x7FF0000000000000), ptr %sunkaddr116, align 8, !noalias !85
  %sunkaddr117 = getelementptr i8, ptr %.6.i.i.i, i64 %lsr.iv.i
  %sunkaddr118 = getelementptr i8, ptr %sunkaddr117, i64 128
  store <8 x double> splat (double 0x7FF0000000000000), ptr %sunkaddr118, align 8, !noalias !85
  %sunkaddr119 = getelementptr i8, ptr %.6.i.i.i, i64 %lsr.iv.i
  %sunkaddr120 = getelementptr i8, ptr %sunkaddr119, i64 192
  store <8 x double> splat (double 0x7FF0000000000000), ptr %sunkaddr120, align 8, !noalias !85
  %lsr.iv.next.i = add nuw nsw i64 %lsr.iv.i, 256
  %2 = icmp eq i64 %1, %lsr.iv.next.i
  br i1 %2, label %middle.block.i, label %vector.body.i, !llvm.loop !90

middle.block.i:                                   ; preds = %vector.body.i
  %n.vec.i = and i64 %.48.1, %const
  %cmp.n.i = icmp eq i64 %.48.1, %n.vec.i
  br i1 %cmp.n.i, label %B0.endif.endif.endif, label %vec.epilog.iter.check.i

vec.epilog.iter.check.i:                          ; preds = %middle.block.i
  %3 = and i64 %.40, 448
  %min.epilog.iters.check.i = icmp eq i64 %3, 0
  br i1 %min.epilog.iters.check.i, label %B120.i.preheader, label %vec.epilog.ph.i, !prof !91

vec.epilog.ph.i:                                  ; preds = %vec.epilog.iter.check.i, %vector.main.loop.iter.check.i
  %vec.epilog.resume.val.i = phi i64 [ %n.vec.i, %vec.epilog.iter.check.i ], [ 0, %vector.main.loop.iter.check.i ]
  %const_mat = add i64 %const, 28
  %n.vec13.i = and i64 %.48.1, %const_mat
  br label %vec.epilog.vector.body.i

vec.epilog.vector.body.i:                         ; preds = %vec.epilog.vector.body.i, %vec.epilog.ph.i
  %index16.i = phi i64 [ %vec.epilog.resume.val.i, %vec.epilog.ph.i ], [ %index.next17.i, %vec.epilog.vector.body.i ]
  %4 = shl i64 %index16.i, 3
  %scevgep19.i = getelementptr i8, ptr %.6.i.i.i, i64 %4
  store <4 x double> splat (double 0x7FF0000000000000), ptr %scevgep19.i, align 8, !noalias !85
  %index.next17.i = add nuw i64 %index16.i, 4
  %5 = icmp eq i64 %n.vec13.i, %index.next17.i
  br i1 %5, label %vec.epilog.middle.block.i, label %vec.epilog.vector.body.i, !llvm.loop !92

vec.epilog.middle.block.i:                        ; preds = %vec.epilog.vector.body.i
  %cmp.n18.i = icmp eq i64 %.48.1, %n.vec13.i
  br i1 %cmp.n18.i, label %B0.endif.endif.endif, label %B120.i.preheader

common.ret:                                       ; preds = %B0.endif.if.if, %B340
  %common.ret.op = phi i32 [ 0, %B340 ], [ 1, %B0.endif.if.if ]
  ret i32 %common.ret.op

B340.loopexit.unr-lcssa:                          ; preds = %B234.B178.loopexit_crit_edge.us.loopexit.us.7
  %lcmp.mod25.not = icmp eq i64 %xtraiter23, 0
  br i1 %lcmp.mod25.not, label %B340, label %B180.endif.us.us.epil.preheader

B180.endif.us.us.epil.preheader:                  ; preds = %B340.loopexit.unr-lcssa, %B180.endif.us.preheader.split.us
  %.224238244.us.us.epil.init = phi i64 [ 0, %B180.endif.us.preheader.split.us ], [ %.231.us.us.7, %B340.loopexit.unr-lcssa ]
  %6 = mul i64 %.224238244.us.us.epil.init, %arg.z.5.1
  %7 = shl i64 %6, 3
  %scevgep = getelementptr i8, ptr %arg.z.4, i64 %7
  %8 = shl i64 %arg.z.5.1, 3
  br label %B180.endif.us.us.epil

B180.endif.us.us.epil:                            ; preds = %B234.B178.loopexit_crit_edge.us.loopexit.us.epil, %B180.endif.us.us.epil.preheader
  %lsr.iv = phi ptr [ %scevgep31, %B234.B178.loopexit_crit_edge.us.loopexit.us.epil ], [ %scevgep, %B180.endif.us.us.epil.preheader ]
  %epil.iter24 = phi i64 [ %epil.iter24.next, %B234.B178.loopexit_crit_edge.us.loopexit.us.epil ], [ 0, %B180.endif.us.us.epil.preheader ]
  br label %B236.endif.endif.else.if.us.epil.us.epil

B236.endif.endif.else.if.us.epil.us.epil:         ; preds = %B236.endif.endif.else.if.us.epil.us.epil, %B180.endif.us.us.epil
  %.359232234.us.epil.us.epil = phi i64 [ 0, %B180.endif.us.us.epil ], [ %.366.us.epil.us.epil, %B236.endif.endif.else.if.us.epil.us.epil ]
  %.398.1.us.epil.us.epil = lshr i64 %.359232234.us.epil.us.epil, 4
  %9 = getelementptr double, ptr %.6.i.i.i, i64 %.398.1.us.epil.us.epil
  %.460.us.epil.us.epil = load double, ptr %9, align 8
  %10 = shl nuw nsw i64 %.359232234.us.epil.us.epil, 3
  %scevgep32 = getelementptr i8, ptr %lsr.iv, i64 %10
  %.513.us.epil.us.epil = load double, ptr %scevgep32, align 8
  %.12.i.epil.us.epil = fcmp olt double %.513.us.epil.us.epil, %.460.us.epil.us.epil
  %.13.i.epil.us.epil = select i1 %.12.i.epil.us.epil, double %.513.us.epil.us.epil, double %.460.us.epil.us.epil
  %.366.us.epil.us.epil = add nuw nsw i64 %.359232234.us.epil.us.epil, 1
  store double %.13.i.epil.us.epil, ptr %9, align 8
  %epil.iter.cmp.not.us.epil = icmp eq i64 %xtraiter, %.366.us.epil.us.epil
  br i1 %epil.iter.cmp.not.us.epil, label %B234.B178.loopexit_crit_edge.us.loopexit.us.epil, label %B236.endif.endif.else.if.us.epil.us.epil, !llvm.loop !93

B234.B178.loopexit_crit_edge.us.loopexit.us.epil: ; preds = %B236.endif.endif.else.if.us.epil.us.epil
  %epil.iter24.next = add i64 %epil.iter24, 1
  %scevgep31 = getelementptr i8, ptr %lsr.iv, i64 %8
  %epil.iter24.cmp.not = icmp eq i64 %epil.iter24.next, %xtraiter23
  br i1 %epil.iter24.cmp.not, label %B340, label %B180.endif.us.us.epil, !llvm.loop !95

B340:                                             ; preds = %B234.B178.loopexit_crit_edge.us, %B234.B178.loopexit_crit_edge.us.loopexit.us.epil, %B340.loopexit.unr-lcssa, %B0.endif.endif.endif
  store ptr %.7.i.i.i.i, ptr %retptr, align 8
  %retptr.repack218 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store ptr null, ptr %retptr.repack218, align 8
  %retptr.repack220 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store i64 %.48.1, ptr %retptr.repack220, align 8
  %retptr.repack222 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store i64 8, ptr %retptr.repack222, align 8
  %retptr.repack224 = getelementptr inbounds nuw i8, ptr %retptr, i64 32
  store ptr %.6.i.i.i, ptr %retptr.repack224, align 8
  %retptr.repack226 = getelementptr inbounds nuw i8, ptr %retptr, i64 40
  store i64 %.48.1, ptr %retptr.repack226, align 8
  %retptr.repack228 = getelementptr inbounds nuw i8, ptr %retptr, i64 48
  store i64 8, ptr %retptr.repack228, align 8
  tail call void @NRT_decref(ptr %arg.z.0)
  br label %common.ret

B0.endif.if.if:                                   ; preds = %B0.endif.endif.endif.i.i, %B0.else.if
  %excinfo.1.0 = phi ptr [ @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.9, %B0.endif.endif.endif.i.i ], [ @.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b.10, %B0.else.if ]
  store ptr %excinfo.1.0, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif:                             ; preds = %B120.i, %vec.epilog.middle.block.i, %middle.block.i, %B0.endif.endif.i
  %.218243.not = icmp slt i64 %arg.z.5.0, 1
  %.353233.not = icmp slt i64 %arg.z.5.1, 1
  %or.cond = or i1 %.218243.not, %.353233.not
  br i1 %or.cond, label %B340, label %B180.endif.us.preheader

B180.endif.us.preheader:                          ; preds = %B0.endif.endif.endif
  %const114 = bitcast i64 9223372036854775800 to i64
  %xtraiter = and i64 %arg.z.5.1, 7
  %11 = icmp samesign ult i64 %arg.z.5.1, 8
  %unroll_iter = and i64 %arg.z.5.1, %const114
  br i1 %11, label %B180.endif.us.preheader.split.us, label %B180.endif.us.preheader6

B180.endif.us.preheader6:                         ; preds = %B180.endif.us.preheader
  %12 = add nsw i64 %arg.z.5.1, -8
  %13 = lshr i64 %12, 3
  %14 = add nuw nsw i64 %13, 1
  %unroll_iter19 = and i64 %14, 4611686018427387902
  %scevgep64 = getelementptr i8, ptr %arg.z.4, i64 120
  %15 = shl i64 %arg.z.5.1, 3
  br label %B180.endif.us

B180.endif.us.preheader.split.us:                 ; preds = %B180.endif.us.preheader
  %16 = add nsw i64 %arg.z.5.0, -1
  %xtraiter23 = and i64 %arg.z.5.0, 7
  %17 = icmp ult i64 %16, 7
  br i1 %17, label %B180.endif.us.us.epil.preheader, label %B180.endif.us.preheader.split.us.new

B180.endif.us.preheader.split.us.new:             ; preds = %B180.endif.us.preheader.split.us
  %unroll_iter27 = and i64 %arg.z.5.0, %const114
  %18 = shl i64 %arg.z.5.1, 6
  %19 = shl i64 %arg.z.5.1, 3
  %scevgep36 = getelementptr i8, ptr %arg.z.4, i64 %19
  %20 = shl i64 %arg.z.5.1, 4
  %scevgep40 = getelementptr i8, ptr %arg.z.4, i64 %20
  %21 = mul i64 %arg.z.5.1, 24
  %scevgep44 = getelementptr i8, ptr %arg.z.4, i64 %21
  %22 = shl i64 %arg.z.5.1, 5
  %scevgep48 = getelementptr i8, ptr %arg.z.4, i64 %22
  %23 = mul i64 %arg.z.5.1, 40
  %scevgep52 = getelementptr i8, ptr %arg.z.4, i64 %23
  %24 = mul i64 %arg.z.5.1, 48
  %scevgep56 = getelementptr i8, ptr %arg.z.4, i64 %24
  %25 = mul i64 %arg.z.5.1, 56
  %scevgep60 = getelementptr i8, ptr %arg.z.4, i64 %25
  br label %B180.endif.us.us

B180.endif.us.us:                                 ; preds = %B234.B178.loopexit_crit_edge.us.loopexit.us.7, %B180.endif.us.preheader.split.us.new
  %lsr.iv61 = phi ptr [ %scevgep62, %B234.B178.loopexit_crit_edge.us.loopexit.us.7 ], [ %scevgep60, %B180.endif.us.preheader.split.us.new ]
  %lsr.iv57 = phi ptr [ %scevgep58, %B234.B178.loopexit_crit_edge.us.loopexit.us.7 ], [ %scevgep56, %B180.endif.us.preheader.split.us.new ]
  %lsr.iv53 = phi ptr [ %scevgep54, %B234.B178.loopexit_crit_edge.us.loopexit.us.7 ], [ %scevgep52, %B180.endif.us.preheader.split.us.new ]
  %lsr.iv49 = phi ptr [ %scevgep50, %B234.B178.loopexit_crit_edge.us.loopexit.us.7 ], [ %scevgep48, %B180.endif.us.preheader.split.us.new ]
  %lsr.iv45 = phi ptr [ %scevgep46, %B234.B178.loopexit_crit_edge.us.loopexit.us.7 ], [ %scevgep44, %B180.endif.us.preheader.split.us.new ]
  %lsr.iv41 = phi ptr [ %scevgep42, %B234.B178.loopexit_crit_edge.us.loopexit.us.7 ], [ %scevgep40, %B180.endif.us.preheader.split.us.new ]
  %lsr.iv37 = phi ptr [ %scevgep38, %B234.B178.loopexit_crit_edge.us.loopexit.us.7 ], [ %scevgep36, %B180.endif.us.preheader.split.us.new ]
  %lsr.iv33 = phi ptr [ %scevgep34, %B234.B178.loopexit_crit_edge.us.loopexit.us.7 ], [ %arg.z.4, %B180.endif.us.preheader.split.us.new ]
  %.224238244.us.us = phi i64 [ 0, %B180.endif.us.preheader.split.us.new ], [ %.231.us.us.7, %B234.B178.loopexit_crit_edge.us.loopexit.us.7 ]
  br label %B236.endif.endif.else.if.us.epil.us

B236.endif.endif.else.if.us.epil.us:              ; preds = %B236.endif.endif.else.if.us.epil.us, %B180.endif.us.us
  %.359232234.us.epil.us = phi i64 [ 0, %B180.endif.us.us ], [ %.366.us.epil.us, %B236.endif.endif.else.if.us.epil.us ]
  %.398.1.us.epil.us = lshr i64 %.359232234.us.epil.us, 4
  %26 = getelementptr double, ptr %.6.i.i.i, i64 %.398.1.us.epil.us
  %.460.us.epil.us = load double, ptr %26, align 8
  %27 = shl nuw nsw i64 %.359232234.us.epil.us, 3
  %scevgep35 = getelementptr i8, ptr %lsr.iv33, i64 %27
  %.513.us.epil.us = load double, ptr %scevgep35, align 8
  %.12.i.epil.us = fcmp olt double %.513.us.epil.us, %.460.us.epil.us
  %.13.i.epil.us = select i1 %.12.i.epil.us, double %.513.us.epil.us, double %.460.us.epil.us
  %.366.us.epil.us = add nuw nsw i64 %.359232234.us.epil.us, 1
  store double %.13.i.epil.us, ptr %26, align 8
  %epil.iter.cmp.not.us = icmp eq i64 %xtraiter, %.366.us.epil.us
  br i1 %epil.iter.cmp.not.us, label %B234.B178.loopexit_crit_edge.us.loopexit.us, label %B236.endif.endif.else.if.us.epil.us, !llvm.loop !93

B234.B178.loopexit_crit_edge.us.loopexit.us:      ; preds = %B236.endif.endif.else.if.us.epil.us
  br label %B236.endif.endif.else.if.us.epil.us.1

B236.endif.endif.else.if.us.epil.us.1:            ; preds = %B236.endif.endif.else.if.us.epil.us.1, %B234.B178.loopexit_crit_edge.us.loopexit.us
  %.359232234.us.epil.us.1 = phi i64 [ 0, %B234.B178.loopexit_crit_edge.us.loopexit.us ], [ %.366.us.epil.us.1, %B236.endif.endif.else.if.us.epil.us.1 ]
  %.398.1.us.epil.us.1 = lshr i64 %.359232234.us.epil.us.1, 4
  %28 = getelementptr double, ptr %.6.i.i.i, i64 %.398.1.us.epil.us.1
  %.460.us.epil.us.1 = load double, ptr %28, align 8
  %29 = shl nuw nsw i64 %.359232234.us.epil.us.1, 3
  %scevgep39 = getelementptr i8, ptr %lsr.iv37, i64 %29
  %.513.us.epil.us.1 = load double, ptr %scevgep39, align 8
  %.12.i.epil.us.1 = fcmp olt double %.513.us.epil.us.1, %.460.us.epil.us.1
  %.13.i.epil.us.1 = select i1 %.12.i.epil.us.1, double %.513.us.epil.us.1, double %.460.us.epil.us.1
  %.366.us.epil.us.1 = add nuw nsw i64 %.359232234.us.epil.us.1, 1
  store double %.13.i.epil.us.1, ptr %28, align 8
  %epil.iter.cmp.not.us.1 = icmp eq i64 %xtraiter, %.366.us.epil.us.1
  br i1 %epil.iter.cmp.not.us.1, label %B234.B178.loopexit_crit_edge.us.loopexit.us.1, label %B236.endif.endif.else.if.us.epil.us.1, !llvm.loop !93

B234.B178.loopexit_crit_edge.us.loopexit.us.1:    ; preds = %B236.endif.endif.else.if.us.epil.us.1
  br label %B236.endif.endif.else.if.us.epil.us.2

B236.endif.endif.else.if.us.epil.us.2:            ; preds = %B236.endif.endif.else.if.us.epil.us.2, %B234.B178.loopexit_crit_edge.us.loopexit.us.1
  %.359232234.us.epil.us.2 = phi i64 [ 0, %B234.B178.loopexit_crit_edge.us.loopexit.us.1 ], [ %.366.us.epil.us.2, %B236.endif.endif.else.if.us.epil.us.2 ]
  %.398.1.us.epil.us.2 = lshr i64 %.359232234.us.epil.us.2, 4
  %30 = getelementptr double, ptr %.6.i.i.i, i64 %.398.1.us.epil.us.2
  %.460.us.epil.us.2 = load double, ptr %30, align 8
  %31 = shl nuw nsw i64 %.359232234.us.epil.us.2, 3
  %scevgep43 = getelementptr i8, ptr %lsr.iv41, i64 %31
  %.513.us.epil.us.2 = load double, ptr %scevgep43, align 8
  %.12.i.epil.us.2 = fcmp olt double %.513.us.epil.us.2, %.460.us.epil.us.2
  %.13.i.epil.us.2 = select i1 %.12.i.epil.us.2, double %.513.us.epil.us.2, double %.460.us.epil.us.2
  %.366.us.epil.us.2 = add nuw nsw i64 %.359232234.us.epil.us.2, 1
  store double %.13.i.epil.us.2, ptr %30, align 8
  %epil.iter.cmp.not.us.2 = icmp eq i64 %xtraiter, %.366.us.epil.us.2
  br i1 %epil.iter.cmp.not.us.2, label %B234.B178.loopexit_crit_edge.us.loopexit.us.2, label %B236.endif.endif.else.if.us.epil.us.2, !llvm.loop !93

B234.B178.loopexit_crit_edge.us.loopexit.us.2:    ; preds = %B236.endif.endif.else.if.us.epil.us.2
  br label %B236.endif.endif.else.if.us.epil.us.3

B236.endif.endif.else.if.us.epil.us.3:            ; preds = %B236.endif.endif.else.if.us.epil.us.3, %B234.B178.loopexit_crit_edge.us.loopexit.us.2
  %.359232234.us.epil.us.3 = phi i64 [ 0, %B234.B178.loopexit_crit_edge.us.loopexit.us.2 ], [ %.366.us.epil.us.3, %B236.endif.endif.else.if.us.epil.us.3 ]
  %.398.1.us.epil.us.3 = lshr i64 %.359232234.us.epil.us.3, 4
  %32 = getelementptr double, ptr %.6.i.i.i, i64 %.398.1.us.epil.us.3
  %.460.us.epil.us.3 = load double, ptr %32, align 8
  %33 = shl nuw nsw i64 %.359232234.us.epil.us.3, 3
  %scevgep47 = getelementptr i8, ptr %lsr.iv45, i64 %33
  %.513.us.epil.us.3 = load double, ptr %scevgep47, align 8
  %.12.i.epil.us.3 = fcmp olt double %.513.us.epil.us.3, %.460.us.epil.us.3
  %.13.i.epil.us.3 = select i1 %.12.i.epil.us.3, double %.513.us.epil.us.3, double %.460.us.epil.us.3
  %.366.us.epil.us.3 = add nuw nsw i64 %.359232234.us.epil.us.3, 1
  store double %.13.i.epil.us.3, ptr %32, align 8
  %epil.iter.cmp.not.us.3 = icmp eq i64 %xtraiter, %.366.us.epil.us.3
  br i1 %epil.iter.cmp.not.us.3, label %B234.B178.loopexit_crit_edge.us.loopexit.us.3, label %B236.endif.endif.else.if.us.epil.us.3, !llvm.loop !93

B234.B178.loopexit_crit_edge.us.loopexit.us.3:    ; preds = %B236.endif.endif.else.if.us.epil.us.3
  br label %B236.endif.endif.else.if.us.epil.us.4

B236.endif.endif.else.if.us.epil.us.4:            ; preds = %B236.endif.endif.else.if.us.epil.us.4, %B234.B178.loopexit_crit_edge.us.loopexit.us.3
  %.359232234.us.epil.us.4 = phi i64 [ 0, %B234.B178.loopexit_crit_edge.us.loopexit.us.3 ], [ %.366.us.epil.us.4, %B236.endif.endif.else.if.us.epil.us.4 ]
  %.398.1.us.epil.us.4 = lshr i64 %.359232234.us.epil.us.4, 4
  %34 = getelementptr double, ptr %.6.i.i.i, i64 %.398.1.us.epil.us.4
  %.460.us.epil.us.4 = load double, ptr %34, align 8
  %35 = shl nuw nsw i64 %.359232234.us.epil.us.4, 3
  %scevgep51 = getelementptr i8, ptr %lsr.iv49, i64 %35
  %.513.us.epil.us.4 = load double, ptr %scevgep51, align 8
  %.12.i.epil.us.4 = fcmp olt double %.513.us.epil.us.4, %.460.us.epil.us.4
  %.13.i.epil.us.4 = select i1 %.12.i.epil.us.4, double %.513.us.epil.us.4, double %.460.us.epil.us.4
  %.366.us.epil.us.4 = add nuw nsw i64 %.359232234.us.epil.us.4, 1
  store double %.13.i.epil.us.4, ptr %34, align 8
  %epil.iter.cmp.not.us.4 = icmp eq i64 %xtraiter, %.366.us.epil.us.4
  br i1 %epil.iter.cmp.not.us.4, label %B234.B178.loopexit_crit_edge.us.loopexit.us.4, label %B236.endif.endif.else.if.us.epil.us.4, !llvm.loop !93

B234.B178.loopexit_crit_edge.us.loopexit.us.4:    ; preds = %B236.endif.endif.else.if.us.epil.us.4
  br label %B236.endif.endif.else.if.us.epil.us.5

B236.endif.endif.else.if.us.epil.us.5:            ; preds = %B236.endif.endif.else.if.us.epil.us.5, %B234.B178.loopexit_crit_edge.us.loopexit.us.4
  %.359232234.us.epil.us.5 = phi i64 [ 0, %B234.B178.loopexit_crit_edge.us.loopexit.us.4 ], [ %.366.us.epil.us.5, %B236.endif.endif.else.if.us.epil.us.5 ]
  %.398.1.us.epil.us.5 = lshr i64 %.359232234.us.epil.us.5, 4
  %36 = getelementptr double, ptr %.6.i.i.i, i64 %.398.1.us.epil.us.5
  %.460.us.epil.us.5 = load double, ptr %36, align 8
  %37 = shl nuw nsw i64 %.359232234.us.epil.us.5, 3
  %scevgep55 = getelementptr i8, ptr %lsr.iv53, i64 %37
  %.513.us.epil.us.5 = load double, ptr %scevgep55, align 8
  %.12.i.epil.us.5 = fcmp olt double %.513.us.epil.us.5, %.460.us.epil.us.5
  %.13.i.epil.us.5 = select i1 %.12.i.epil.us.5, double %.513.us.epil.us.5, double %.460.us.epil.us.5
  %.366.us.epil.us.5 = add nuw nsw i64 %.359232234.us.epil.us.5, 1
  store double %.13.i.epil.us.5, ptr %36, align 8
  %epil.iter.cmp.not.us.5 = icmp eq i64 %xtraiter, %.366.us.epil.us.5
  br i1 %epil.iter.cmp.not.us.5, label %B234.B178.loopexit_crit_edge.us.loopexit.us.5, label %B236.endif.endif.else.if.us.epil.us.5, !llvm.loop !93

B234.B178.loopexit_crit_edge.us.loopexit.us.5:    ; preds = %B236.endif.endif.else.if.us.epil.us.5
  br label %B236.endif.endif.else.if.us.epil.us.6

B236.endif.endif.else.if.us.epil.us.6:            ; preds = %B236.endif.endif.else.if.us.epil.us.6, %B234.B178.loopexit_crit_edge.us.loopexit.us.5
  %.359232234.us.epil.us.6 = phi i64 [ 0, %B234.B178.loopexit_crit_edge.us.loopexit.us.5 ], [ %.366.us.epil.us.6, %B236.endif.endif.else.if.us.epil.us.6 ]
  %.398.1.us.epil.us.6 = lshr i64 %.359232234.us.epil.us.6, 4
  %38 = getelementptr double, ptr %.6.i.i.i, i64 %.398.1.us.epil.us.6
  %.460.us.epil.us.6 = load double, ptr %38, align 8
  %39 = shl nuw nsw i64 %.359232234.us.epil.us.6, 3
  %scevgep59 = getelementptr i8, ptr %lsr.iv57, i64 %39
  %.513.us.epil.us.6 = load double, ptr %scevgep59, align 8
  %.12.i.epil.us.6 = fcmp olt double %.513.us.epil.us.6, %.460.us.epil.us.6
  %.13.i.epil.us.6 = select i1 %.12.i.epil.us.6, double %.513.us.epil.us.6, double %.460.us.epil.us.6
  %.366.us.epil.us.6 = add nuw nsw i64 %.359232234.us.epil.us.6, 1
  store double %.13.i.epil.us.6, ptr %38, align 8
  %epil.iter.cmp.not.us.6 = icmp eq i64 %xtraiter, %.366.us.epil.us.6
  br i1 %epil.iter.cmp.not.us.6, label %B234.B178.loopexit_crit_edge.us.loopexit.us.6, label %B236.endif.endif.else.if.us.epil.us.6, !llvm.loop !93

B234.B178.loopexit_crit_edge.us.loopexit.us.6:    ; preds = %B236.endif.endif.else.if.us.epil.us.6
  br label %B236.endif.endif.else.if.us.epil.us.7

B236.endif.endif.else.if.us.epil.us.7:            ; preds = %B236.endif.endif.else.if.us.epil.us.7, %B234.B178.loopexit_crit_edge.us.loopexit.us.6
  %.359232234.us.epil.us.7 = phi i64 [ 0, %B234.B178.loopexit_crit_edge.us.loopexit.us.6 ], [ %.366.us.epil.us.7, %B236.endif.endif.else.if.us.epil.us.7 ]
  %.398.1.us.epil.us.7 = lshr i64 %.359232234.us.epil.us.7, 4
  %40 = getelementptr double, ptr %.6.i.i.i, i64 %.398.1.us.epil.us.7
  %.460.us.epil.us.7 = load double, ptr %40, align 8
  %41 = shl nuw nsw i64 %.359232234.us.epil.us.7, 3
  %scevgep63 = getelementptr i8, ptr %lsr.iv61, i64 %41
  %.513.us.epil.us.7 = load double, ptr %scevgep63, align 8
  %.12.i.epil.us.7 = fcmp olt double %.513.us.epil.us.7, %.460.us.epil.us.7
  %.13.i.epil.us.7 = select i1 %.12.i.epil.us.7, double %.513.us.epil.us.7, double %.460.us.epil.us.7
  %.366.us.epil.us.7 = add nuw nsw i64 %.359232234.us.epil.us.7, 1
  store double %.13.i.epil.us.7, ptr %40, align 8
  %epil.iter.cmp.not.us.7 = icmp eq i64 %xtraiter, %.366.us.epil.us.7
  br i1 %epil.iter.cmp.not.us.7, label %B234.B178.loopexit_crit_edge.us.loopexit.us.7, label %B236.endif.endif.else.if.us.epil.us.7, !llvm.loop !93

B234.B178.loopexit_crit_edge.us.loopexit.us.7:    ; preds = %B236.endif.endif.else.if.us.epil.us.7
  %.231.us.us.7 = add nuw i64 %.224238244.us.us, 8
  %scevgep34 = getelementptr i8, ptr %lsr.iv33, i64 %18
  %scevgep38 = getelementptr i8, ptr %lsr.iv37, i64 %18
  %scevgep42 = getelementptr i8, ptr %lsr.iv41, i64 %18
  %scevgep46 = getelementptr i8, ptr %lsr.iv45, i64 %18
  %scevgep50 = getelementptr i8, ptr %lsr.iv49, i64 %18
  %scevgep54 = getelementptr i8, ptr %lsr.iv53, i64 %18
  %scevgep58 = getelementptr i8, ptr %lsr.iv57, i64 %18
  %scevgep62 = getelementptr i8, ptr %lsr.iv61, i64 %18
  %niter28.ncmp.7 = icmp eq i64 %.231.us.us.7, %unroll_iter27
  br i1 %niter28.ncmp.7, label %B340.loopexit.unr-lcssa, label %B180.endif.us.us

B180.endif.us:                                    ; preds = %B180.endif.us.preheader6, %B234.B178.loopexit_crit_edge.us
  %lsr.iv100 = phi ptr [ %arg.z.4, %B180.endif.us.preheader6 ], [ %scevgep101, %B234.B178.loopexit_crit_edge.us ]
  %lsr.iv65 = phi ptr [ %scevgep64, %B180.endif.us.preheader6 ], [ %scevgep66, %B234.B178.loopexit_crit_edge.us ]
  %.224238244.us = phi i64 [ %.231.us, %B234.B178.loopexit_crit_edge.us ], [ 0, %B180.endif.us.preheader6 ]
  %42 = icmp eq i64 %13, 0
  %.508.us = mul i64 %.224238244.us, %arg.z.5.1
  %43 = getelementptr double, ptr %arg.z.4, i64 %.508.us
  br i1 %42, label %B236.endif.endif.else.if.us.epil.preheader8, label %B236.endif.endif.else.if.us.preheader

B236.endif.endif.else.if.us.preheader:            ; preds = %B180.endif.us
  br label %B236.endif.endif.else.if.us

B236.endif.endif.else.if.us:                      ; preds = %B236.endif.endif.else.if.us.preheader, %B236.endif.endif.else.if.us
  %.359232234.us = phi i64 [ %.366.us.7.1, %B236.endif.endif.else.if.us ], [ 0, %B236.endif.endif.else.if.us.preheader ]
  %niter = phi i64 [ %niter.next.1, %B236.endif.endif.else.if.us ], [ 0, %B236.endif.endif.else.if.us.preheader ]
  %44 = shl i64 %niter, 2
  %scevgep99 = getelementptr i8, ptr %.6.i.i.i, i64 %44
  %.460.us = load double, ptr %scevgep99, align 8
  %45 = shl i64 %.359232234.us, 3
  %scevgep96 = getelementptr i8, ptr %lsr.iv65, i64 %45
  %scevgep97 = getelementptr i8, ptr %scevgep96, i64 -120
  %.513.us = load double, ptr %scevgep97, align 8
  %.12.i = fcmp olt double %.513.us, %.460.us
  %.13.i = select i1 %.12.i, double %.513.us, double %.460.us
  store double %.13.i, ptr %scevgep99, align 8
  %46 = shl i64 %.359232234.us, 3
  %scevgep94 = getelementptr i8, ptr %lsr.iv65, i64 %46
  %scevgep95 = getelementptr i8, ptr %scevgep94, i64 -112
  %.513.us.1 = load double, ptr %scevgep95, align 8
  %.12.i.1 = fcmp olt double %.513.us.1, %.13.i
  %.13.i.1 = select i1 %.12.i.1, double %.513.us.1, double %.13.i
  store double %.13.i.1, ptr %scevgep99, align 8
  %47 = shl i64 %.359232234.us, 3
  %scevgep92 = getelementptr i8, ptr %lsr.iv65, i64 %47
  %scevgep93 = getelementptr i8, ptr %scevgep92, i64 -104
  %.513.us.2 = load double, ptr %scevgep93, align 8
  %.12.i.2 = fcmp olt double %.513.us.2, %.13.i.1
  %.13.i.2 = select i1 %.12.i.2, double %.513.us.2, double %.13.i.1
  store double %.13.i.2, ptr %scevgep99, align 8
  %48 = shl i64 %.359232234.us, 3
  %scevgep90 = getelementptr i8, ptr %lsr.iv65, i64 %48
  %scevgep91 = getelementptr i8, ptr %scevgep90, i64 -96
  %.513.us.3 = load double, ptr %scevgep91, align 8
  %.12.i.3 = fcmp olt double %.513.us.3, %.13.i.2
  %.13.i.3 = select i1 %.12.i.3, double %.513.us.3, double %.13.i.2
  store double %.13.i.3, ptr %scevgep99, align 8
  %49 = shl i64 %.359232234.us, 3
  %scevgep88 = getelementptr i8, ptr %lsr.iv65, i64 %49
  %scevgep89 = getelementptr i8, ptr %scevgep88, i64 -88
  %.513.us.4 = load double, ptr %scevgep89, align 8
  %.12.i.4 = fcmp olt double %.513.us.4, %.13.i.3
  %.13.i.4 = select i1 %.12.i.4, double %.513.us.4, double %.13.i.3
  store double %.13.i.4, ptr %scevgep99, align 8
  %50 = shl i64 %.359232234.us, 3
  %scevgep86 = getelementptr i8, ptr %lsr.iv65, i64 %50
  %scevgep87 = getelementptr i8, ptr %scevgep86, i64 -80
  %.513.us.5 = load double, ptr %scevgep87, align 8
  %.12.i.5 = fcmp olt double %.513.us.5, %.13.i.4
  %.13.i.5 = select i1 %.12.i.5, double %.513.us.5, double %.13.i.4
  store double %.13.i.5, ptr %scevgep99, align 8
  %51 = shl i64 %.359232234.us, 3
  %scevgep84 = getelementptr i8, ptr %lsr.iv65, i64 %51
  %scevgep85 = getelementptr i8, ptr %scevgep84, i64 -72
  %.513.us.6 = load double, ptr %scevgep85, align 8
  %.12.i.6 = fcmp olt double %.513.us.6, %.13.i.5
  %.13.i.6 = select i1 %.12.i.6, double %.513.us.6, double %.13.i.5
  store double %.13.i.6, ptr %scevgep99, align 8
  %52 = shl i64 %.359232234.us, 3
  %scevgep82 = getelementptr i8, ptr %lsr.iv65, i64 %52
  %scevgep83 = getelementptr i8, ptr %scevgep82, i64 -64
  %.513.us.7 = load double, ptr %scevgep83, align 8
  %.12.i.7 = fcmp olt double %.513.us.7, %.13.i.6
  %.13.i.7 = select i1 %.12.i.7, double %.513.us.7, double %.13.i.6
  store double %.13.i.7, ptr %scevgep99, align 8
  %53 = shl i64 %niter, 2
  %scevgep98 = getelementptr i8, ptr %.6.i.i.i, i64 %53
  %.460.us.1 = load double, ptr %scevgep98, align 8
  %54 = shl i64 %.359232234.us, 3
  %scevgep80 = getelementptr i8, ptr %lsr.iv65, i64 %54
  %scevgep81 = getelementptr i8, ptr %scevgep80, i64 -56
  %.513.us.120 = load double, ptr %scevgep81, align 8
  %.12.i.121 = fcmp olt double %.513.us.120, %.460.us.1
  %.13.i.122 = select i1 %.12.i.121, double %.513.us.120, double %.460.us.1
  store double %.13.i.122, ptr %scevgep98, align 8
  %55 = shl i64 %.359232234.us, 3
  %scevgep78 = getelementptr i8, ptr %lsr.iv65, i64 %55
  %scevgep79 = getelementptr i8, ptr %scevgep78, i64 -48
  %.513.us.1.1 = load double, ptr %scevgep79, align 8
  %.12.i.1.1 = fcmp olt double %.513.us.1.1, %.13.i.122
  %.13.i.1.1 = select i1 %.12.i.1.1, double %.513.us.1.1, double %.13.i.122
  store double %.13.i.1.1, ptr %scevgep98, align 8
  %56 = shl i64 %.359232234.us, 3
  %scevgep76 = getelementptr i8, ptr %lsr.iv65, i64 %56
  %scevgep77 = getelementptr i8, ptr %scevgep76, i64 -40
  %.513.us.2.1 = load double, ptr %scevgep77, align 8
  %.12.i.2.1 = fcmp olt double %.513.us.2.1, %.13.i.1.1
  %.13.i.2.1 = select i1 %.12.i.2.1, double %.513.us.2.1, double %.13.i.1.1
  store double %.13.i.2.1, ptr %scevgep98, align 8
  %57 = shl i64 %.359232234.us, 3
  %scevgep74 = getelementptr i8, ptr %lsr.iv65, i64 %57
  %scevgep75 = getelementptr i8, ptr %scevgep74, i64 -32
  %.513.us.3.1 = load double, ptr %scevgep75, align 8
  %.12.i.3.1 = fcmp olt double %.513.us.3.1, %.13.i.2.1
  %.13.i.3.1 = select i1 %.12.i.3.1, double %.513.us.3.1, double %.13.i.2.1
  store double %.13.i.3.1, ptr %scevgep98, align 8
  %58 = shl i64 %.359232234.us, 3
  %scevgep72 = getelementptr i8, ptr %lsr.iv65, i64 %58
  %scevgep73 = getelementptr i8, ptr %scevgep72, i64 -24
  %.513.us.4.1 = load double, ptr %scevgep73, align 8
  %.12.i.4.1 = fcmp olt double %.513.us.4.1, %.13.i.3.1
  %.13.i.4.1 = select i1 %.12.i.4.1, double %.513.us.4.1, double %.13.i.3.1
  store double %.13.i.4.1, ptr %scevgep98, align 8
  %59 = shl i64 %.359232234.us, 3
  %scevgep70 = getelementptr i8, ptr %lsr.iv65, i64 %59
  %scevgep71 = getelementptr i8, ptr %scevgep70, i64 -16
  %.513.us.5.1 = load double, ptr %scevgep71, align 8
  %.12.i.5.1 = fcmp olt double %.513.us.5.1, %.13.i.4.1
  %.13.i.5.1 = select i1 %.12.i.5.1, double %.513.us.5.1, double %.13.i.4.1
  store double %.13.i.5.1, ptr %scevgep98, align 8
  %60 = shl i64 %.359232234.us, 3
  %scevgep68 = getelementptr i8, ptr %lsr.iv65, i64 %60
  %scevgep69 = getelementptr i8, ptr %scevgep68, i64 -8
  %.513.us.6.1 = load double, ptr %scevgep69, align 8
  %.12.i.6.1 = fcmp olt double %.513.us.6.1, %.13.i.5.1
  %.13.i.6.1 = select i1 %.12.i.6.1, double %.513.us.6.1, double %.13.i.5.1
  store double %.13.i.6.1, ptr %scevgep98, align 8
  %61 = shl i64 %.359232234.us, 3
  %scevgep67 = getelementptr i8, ptr %lsr.iv65, i64 %61
  %.513.us.7.1 = load double, ptr %scevgep67, align 8
  %.12.i.7.1 = fcmp olt double %.513.us.7.1, %.13.i.6.1
  %.13.i.7.1 = select i1 %.12.i.7.1, double %.513.us.7.1, double %.13.i.6.1
  %.366.us.7.1 = add nuw i64 %.359232234.us, 16
  store double %.13.i.7.1, ptr %scevgep98, align 8
  %niter.next.1 = add i64 %niter, 2
  %niter.ncmp.1 = icmp eq i64 %unroll_iter19, %niter.next.1
  br i1 %niter.ncmp.1, label %B234.B178.loopexit_crit_edge.us.unr-lcssa.unr-lcssa, label %B236.endif.endif.else.if.us

B234.B178.loopexit_crit_edge.us.unr-lcssa.unr-lcssa: ; preds = %B236.endif.endif.else.if.us
  %62 = and i64 %14, 1
  %63 = icmp eq i64 %62, 0
  br i1 %63, label %B234.B178.loopexit_crit_edge.us.unr-lcssa, label %B236.endif.endif.else.if.us.epil.preheader8

B236.endif.endif.else.if.us.epil.preheader8:      ; preds = %B234.B178.loopexit_crit_edge.us.unr-lcssa.unr-lcssa, %B180.endif.us
  %.359232234.us.epil.init = phi i64 [ 0, %B180.endif.us ], [ %.366.us.7.1, %B234.B178.loopexit_crit_edge.us.unr-lcssa.unr-lcssa ]
  %.398.1.us.epil12 = lshr i64 %.359232234.us.epil.init, 4
  %64 = getelementptr double, ptr %.6.i.i.i, i64 %.398.1.us.epil12
  %.460.us.epil13 = load double, ptr %64, align 8
  %65 = getelementptr double, ptr %43, i64 %.359232234.us.epil.init
  %.513.us.epil14 = load double, ptr %65, align 8
  %.12.i.epil15 = fcmp olt double %.513.us.epil14, %.460.us.epil13
  %.13.i.epil16 = select i1 %.12.i.epil15, double %.513.us.epil14, double %.460.us.epil13
  store double %.13.i.epil16, ptr %64, align 8
  %66 = getelementptr i8, ptr %65, i64 8
  %.513.us.1.epil = load double, ptr %66, align 8
  %.12.i.1.epil = fcmp olt double %.513.us.1.epil, %.13.i.epil16
  %.13.i.1.epil = select i1 %.12.i.1.epil, double %.513.us.1.epil, double %.13.i.epil16
  store double %.13.i.1.epil, ptr %64, align 8
  %67 = getelementptr i8, ptr %65, i64 16
  %.513.us.2.epil = load double, ptr %67, align 8
  %.12.i.2.epil = fcmp olt double %.513.us.2.epil, %.13.i.1.epil
  %.13.i.2.epil = select i1 %.12.i.2.epil, double %.513.us.2.epil, double %.13.i.1.epil
  store double %.13.i.2.epil, ptr %64, align 8
  %68 = getelementptr i8, ptr %65, i64 24
  %.513.us.3.epil = load double, ptr %68, align 8
  %.12.i.3.epil = fcmp olt double %.513.us.3.epil, %.13.i.2.epil
  %.13.i.3.epil = select i1 %.12.i.3.epil, double %.513.us.3.epil, double %.13.i.2.epil
  store double %.13.i.3.epil, ptr %64, align 8
  %69 = getelementptr i8, ptr %65, i64 32
  %.513.us.4.epil = load double, ptr %69, align 8
  %.12.i.4.epil = fcmp olt double %.513.us.4.epil, %.13.i.3.epil
  %.13.i.4.epil = select i1 %.12.i.4.epil, double %.513.us.4.epil, double %.13.i.3.epil
  store double %.13.i.4.epil, ptr %64, align 8
  %70 = getelementptr i8, ptr %65, i64 40
  %.513.us.5.epil = load double, ptr %70, align 8
  %.12.i.5.epil = fcmp olt double %.513.us.5.epil, %.13.i.4.epil
  %.13.i.5.epil = select i1 %.12.i.5.epil, double %.513.us.5.epil, double %.13.i.4.epil
  store double %.13.i.5.epil, ptr %64, align 8
  %71 = getelementptr i8, ptr %65, i64 48
  %.513.us.6.epil = load double, ptr %71, align 8
  %.12.i.6.epil = fcmp olt double %.513.us.6.epil, %.13.i.5.epil
  %.13.i.6.epil = select i1 %.12.i.6.epil, double %.513.us.6.epil, double %.13.i.5.epil
  store double %.13.i.6.epil, ptr %64, align 8
  %72 = getelementptr i8, ptr %65, i64 56
  %.513.us.7.epil = load double, ptr %72, align 8
  %.12.i.7.epil = fcmp olt double %.513.us.7.epil, %.13.i.6.epil
  %.13.i.7.epil = select i1 %.12.i.7.epil, double %.513.us.7.epil, double %.13.i.6.epil
  store double %.13.i.7.epil, ptr %64, align 8
  br label %B234.B178.loopexit_crit_edge.us.unr-lcssa

B234.B178.loopexit_crit_edge.us.unr-lcssa:        ; preds = %B234.B178.loopexit_crit_edge.us.unr-lcssa.unr-lcssa, %B236.endif.endif.else.if.us.epil.preheader8
  %73 = icmp eq i64 %xtraiter, 0
  br i1 %73, label %B234.B178.loopexit_crit_edge.us, label %B236.endif.endif.else.if.us.epil.preheader

B236.endif.endif.else.if.us.epil.preheader:       ; preds = %B234.B178.loopexit_crit_edge.us.unr-lcssa
  br label %B236.endif.endif.else.if.us.epil

B236.endif.endif.else.if.us.epil:                 ; preds = %B236.endif.endif.else.if.us.epil.preheader, %B236.endif.endif.else.if.us.epil
  %lsr.iv103 = phi i64 [ %xtraiter, %B236.endif.endif.else.if.us.epil.preheader ], [ %lsr.iv.next, %B236.endif.endif.else.if.us.epil ]
  %.359232234.us.epil = phi i64 [ %.366.us.epil, %B236.endif.endif.else.if.us.epil ], [ %unroll_iter, %B236.endif.endif.else.if.us.epil.preheader ]
  %.398.1.us.epil = lshr i64 %.359232234.us.epil, 4
  %74 = getelementptr double, ptr %.6.i.i.i, i64 %.398.1.us.epil
  %.460.us.epil = load double, ptr %74, align 8
  %75 = shl i64 %.359232234.us.epil, 3
  %scevgep102 = getelementptr i8, ptr %lsr.iv100, i64 %75
  %.513.us.epil = load double, ptr %scevgep102, align 8
  %.12.i.epil = fcmp olt double %.513.us.epil, %.460.us.epil
  %.13.i.epil = select i1 %.12.i.epil, double %.513.us.epil, double %.460.us.epil
  %.366.us.epil = add nuw nsw i64 %.359232234.us.epil, 1
  store double %.13.i.epil, ptr %74, align 8
  %lsr.iv.next = add nsw i64 %lsr.iv103, -1
  %epil.iter.cmp.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %epil.iter.cmp.not, label %B234.B178.loopexit_crit_edge.us, label %B236.endif.endif.else.if.us.epil, !llvm.loop !93

B234.B178.loopexit_crit_edge.us:                  ; preds = %B236.endif.endif.else.if.us.epil, %B234.B178.loopexit_crit_edge.us.unr-lcssa
  %.231.us = add nuw nsw i64 %.224238244.us, 1
  %scevgep66 = getelementptr i8, ptr %lsr.iv65, i64 %15
  %scevgep101 = getelementptr i8, ptr %lsr.iv100, i64 %15
  %exitcond263.not = icmp eq i64 %.231.us, %arg.z.5.0
  br i1 %exitcond263.not, label %B340, label %B180.endif.us
}

; Function Attrs: mustprogress nofree noinline norecurse nounwind willreturn memory(argmem: readwrite)
define linkonce_odr void @NRT_incref(ptr captures(address_is_null) %.1) local_unnamed_addr #2 {
.3:
  %.4 = icmp eq ptr %.1, null
  br i1 %.4, label %common.ret, label %.3.endif, !prof !11

common.ret:                                       ; preds = %.3.endif, %.3
  ret void

.3.endif:                                         ; preds = %.3
  %.4.i = atomicrmw add ptr %.1, i64 1 monotonic, align 8
  br label %common.ret
}

; Function Attrs: noinline
define linkonce_odr void @NRT_decref(ptr %.1) local_unnamed_addr #3 {
.3:
  %.4 = icmp eq ptr %.1, null
  br i1 %.4, label %common.ret1, label %.3.endif, !prof !11

common.ret1:                                      ; preds = %.3.endif, %.3
  ret void

.3.endif:                                         ; preds = %.3
  fence release
  %0 = tail call i8 @llvm.x86.atomic.sub.cc.i64(ptr nonnull %.1, i64 1, i32 4)
  %1 = trunc i8 %0 to i1
  br i1 %1, label %.3.endif.if, label %common.ret1, !prof !11

.3.endif.if:                                      ; preds = %.3.endif
  fence acquire
  tail call void @NRT_MemInfo_call_dtor(ptr nonnull %.1)
  ret void
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(inaccessiblemem: write)
declare void @llvm.assume(i1 noundef) #4

; Function Attrs: nounwind
declare i8 @llvm.x86.atomic.sub.cc.i64(ptr, i64, i32 immarg) #5

declare void @NRT_MemInfo_call_dtor(ptr) local_unnamed_addr

define linkonce_odr range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels8rheology5prony7_law_ofB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29d(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, double %arg.form.0, ptr %arg.form.1.0, ptr readnone captures(none) %arg.form.1.1, i64 %arg.form.1.2, i64 %arg.form.1.3, ptr readonly captures(none) %arg.form.1.4, i64 %arg.form.1.5.0, i64 %arg.form.1.6.0, ptr %arg.form.2.0, ptr readnone captures(none) %arg.form.2.1, i64 %arg.form.2.2, i64 %arg.form.2.3, ptr readonly captures(none) %arg.form.2.4, i64 %arg.form.2.5.0, i64 %arg.form.2.6.0, double %arg.dt) local_unnamed_addr {
B0:
  %.437 = alloca [3 x double], align 8
  %.99.fca.5.0.load.fr349 = freeze i64 %arg.form.2.2
  %excinfo.6 = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.437, i8 0, i64 24, i1 false)
  store ptr null, ptr %excinfo.6, align 8
  %.943 = alloca double, align 8
  store double 0.000000e+00, ptr %.943, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  tail call void @NRT_incref(ptr %arg.form.1.0)
  tail call void @NRT_incref(ptr %arg.form.2.0)
  %.14.i = icmp slt i64 %.99.fca.5.0.load.fr349, 0
  br i1 %.14.i, label %B0.if.if, label %B0.endif.endif.i, !prof !11

B0.endif.endif.i:                                 ; preds = %B0
  %const = bitcast i64 1152921504606846968 to i64
  %const_mat252 = add i64 %const, 7
  %.30.i = icmp samesign ugt i64 %.99.fca.5.0.load.fr349, %const_mat252
  br i1 %.30.i, label %B0.if.if, label %B0.endif.endif.endif.i, !prof !11

B0.endif.endif.endif.i:                           ; preds = %B0.endif.endif.i
  %.29.i = shl nuw nsw i64 %.99.fca.5.0.load.fr349, 3
  %.7.i.i.i = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.29.i, i32 32), !noalias !96
  %.8.i.i.i = icmp eq ptr %.7.i.i.i, null
  br i1 %.8.i.i.i, label %B0.if.if, label %B0.endif.endif.endif.i12, !prof !11

B260:                                             ; preds = %B260.lr.ph, %B418
  %.358664666 = phi i64 [ 0, %B260.lr.ph ], [ %.365, %B418 ]
  %.365 = add nuw nsw i64 %.358664666, 1
  %0 = shl nuw nsw i64 %.358664666, 3
  %scevgep246 = getelementptr i8, ptr %arg.form.2.4, i64 %0
  %.428 = load double, ptr %scevgep246, align 8
  %.436 = fdiv double %arg.dt, %.428
  %.441 = call i32 @_ZN18elastomer_friction7kernels8rheology5prony7momentsB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd(ptr nonnull %.437, ptr nonnull %excinfo.6, double %.436)
  %.451.fca.0.load = load double, ptr %.437, align 8
  %sunkaddr = getelementptr inbounds i8, ptr %.437, i64 8
  %.451.fca.1.load = load double, ptr %sunkaddr, align 8
  %sunkaddr253 = getelementptr inbounds i8, ptr %.437, i64 16
  %.451.fca.2.load = load double, ptr %sunkaddr253, align 8
  switch i32 %.441, label %B260.endif.if.if [
    i32 -2, label %B260.endif.endif
    i32 0, label %B260.endif.endif
  ], !prof !1

B340:                                             ; preds = %B260.endif.endif
  %.486 = fsub double 1.000000e+00, %.451.fca.0.load
  br label %B418

B350:                                             ; preds = %B260.endif.endif
  %.534 = fdiv double %.492, %.428
  %.535 = tail call double @llvm.exp.f64(double %.534)
  br label %B418

B418:                                             ; preds = %B350, %B340
  %"$phi418.1.2.1" = phi double [ %.486, %B340 ], [ %.535, %B350 ]
  %1 = shl nuw nsw i64 %.358664666, 3
  %scevgep245 = getelementptr i8, ptr %.6.i.i, i64 %1
  %.605 = fcmp ogt double %"$phi418.1.2.1", 1.000000e-100
  %storemerge = select i1 %.605, double %"$phi418.1.2.1", double 0.000000e+00
  store double %storemerge, ptr %scevgep245, align 8
  %2 = shl nuw nsw i64 %.358664666, 3
  %scevgep244 = getelementptr i8, ptr %arg.form.1.4, i64 %2
  %.673 = load double, ptr %scevgep244, align 8
  %.678 = fmul double %.451.fca.1.load, %.673
  %.720 = fmul double %.451.fca.2.load, %.673
  %3 = shl nuw nsw i64 %.358664666, 3
  %scevgep243 = getelementptr i8, ptr %.6.i.i18, i64 %3
  store double %.678, ptr %scevgep243, align 8
  %4 = shl nuw nsw i64 %.358664666, 3
  %scevgep242 = getelementptr i8, ptr %.6.i.i39, i64 %4
  store double %.720, ptr %scevgep242, align 8
  %.817 = load double, ptr %scevgep244, align 8
  %.822 = fmul double %.451.fca.0.load, %.817
  %.828 = fdiv double %.451.fca.2.load, %.451.fca.0.load
  %5 = shl nuw nsw i64 %.358664666, 3
  %scevgep241 = getelementptr i8, ptr %.6.i.i60, i64 %5
  store double %.822, ptr %scevgep241, align 8
  %6 = shl nuw nsw i64 %.358664666, 3
  %scevgep240 = getelementptr i8, ptr %.6.i.i81, i64 %6
  store double %.828, ptr %scevgep240, align 8
  %exitcond.not = icmp eq i64 %.99.fca.5.0.load.fr349, %.365
  br i1 %exitcond.not, label %.89.endif.preheader.i, label %B260

.89.endif.preheader.i:                            ; preds = %B418
  tail call void @NRT_incref(ptr nonnull %.7.i.i.i35)
  %xtraiter.i = and i64 %.99.fca.5.0.load.fr349, 7
  %7 = icmp samesign ult i64 %.99.fca.5.0.load.fr349, 8
  br i1 %7, label %.89.endif.epil.preheader.i, label %.89.endif.preheader.new.i, !prof !106

.89.endif.preheader.new.i:                        ; preds = %.89.endif.preheader.i
  %unroll_iter.i = and i64 %.99.fca.5.0.load.fr349, %const
  %8 = add nsw i64 %.99.fca.5.0.load.fr349, -8
  %9 = lshr i64 %8, 3
  %10 = add nuw nsw i64 %9, 1
  %xtraiter = and i64 %10, 3
  %11 = and i64 %8, 24
  %lcmp.mod.not = icmp eq i64 %11, 24
  br i1 %lcmp.mod.not, label %.89.endif.i.preheader, label %.89.endif.i.prol.preheader, !prof !107

.89.endif.i.prol.preheader:                       ; preds = %.89.endif.preheader.new.i
  br label %.89.endif.i.prol

.89.endif.i.prol:                                 ; preds = %.89.endif.i.prol.preheader, %.89.endif.i.prol
  %lsr.iv238 = phi i64 [ %xtraiter, %.89.endif.i.prol.preheader ], [ %lsr.iv.next239, %.89.endif.i.prol ]
  %.77.013.i.prol = phi ptr [ %.114.7.i.prol, %.89.endif.i.prol ], [ %.6.i.i39, %.89.endif.i.prol.preheader ]
  %.72.012.i.prol = phi double [ %.108.7.i.prol, %.89.endif.i.prol ], [ 0.000000e+00, %.89.endif.i.prol.preheader ]
  %.106.i.prol = load double, ptr %.77.013.i.prol, align 8, !noalias !108
  %.108.i.prol = fadd double %.72.012.i.prol, %.106.i.prol
  %.114.i.prol = getelementptr i8, ptr %.77.013.i.prol, i64 8
  %.106.1.i.prol = load double, ptr %.114.i.prol, align 8, !noalias !108
  %.108.1.i.prol = fadd double %.108.i.prol, %.106.1.i.prol
  %.114.1.i.prol = getelementptr i8, ptr %.77.013.i.prol, i64 16
  %.106.2.i.prol = load double, ptr %.114.1.i.prol, align 8, !noalias !108
  %.108.2.i.prol = fadd double %.108.1.i.prol, %.106.2.i.prol
  %.114.2.i.prol = getelementptr i8, ptr %.77.013.i.prol, i64 24
  %.106.3.i.prol = load double, ptr %.114.2.i.prol, align 8, !noalias !108
  %.108.3.i.prol = fadd double %.108.2.i.prol, %.106.3.i.prol
  %.114.3.i.prol = getelementptr i8, ptr %.77.013.i.prol, i64 32
  %.106.4.i.prol = load double, ptr %.114.3.i.prol, align 8, !noalias !108
  %.108.4.i.prol = fadd double %.108.3.i.prol, %.106.4.i.prol
  %.114.4.i.prol = getelementptr i8, ptr %.77.013.i.prol, i64 40
  %.106.5.i.prol = load double, ptr %.114.4.i.prol, align 8, !noalias !108
  %.108.5.i.prol = fadd double %.108.4.i.prol, %.106.5.i.prol
  %.114.5.i.prol = getelementptr i8, ptr %.77.013.i.prol, i64 48
  %.106.6.i.prol = load double, ptr %.114.5.i.prol, align 8, !noalias !108
  %.108.6.i.prol = fadd double %.108.5.i.prol, %.106.6.i.prol
  %.114.6.i.prol = getelementptr i8, ptr %.77.013.i.prol, i64 56
  %.106.7.i.prol = load double, ptr %.114.6.i.prol, align 8, !noalias !108
  %.108.7.i.prol = fadd double %.108.6.i.prol, %.106.7.i.prol
  %.114.7.i.prol = getelementptr i8, ptr %.77.013.i.prol, i64 64
  %lsr.iv.next239 = add i64 %lsr.iv238, -1
  %prol.iter.cmp.not = icmp eq i64 %lsr.iv.next239, 0
  br i1 %prol.iter.cmp.not, label %.89.endif.i.prol.loopexit, label %.89.endif.i.prol, !prof !111, !llvm.loop !112

.89.endif.i.prol.loopexit:                        ; preds = %.89.endif.i.prol
  %12 = shl nuw nsw i64 %xtraiter, 6
  %scevgep54 = getelementptr i8, ptr %.6.i.i39, i64 %12
  %13 = shl nuw nsw i64 %xtraiter, 3
  %14 = sub nsw i64 %unroll_iter.i, %13
  %15 = icmp ult i64 %8, 24
  br i1 %15, label %common.ret.loopexit.unr-lcssa.i, label %.89.endif.i.preheader, !prof !113

.89.endif.i.preheader:                            ; preds = %.89.endif.preheader.new.i, %.89.endif.i.prol.loopexit
  %lsr.iv.i.ph = phi i64 [ %14, %.89.endif.i.prol.loopexit ], [ %unroll_iter.i, %.89.endif.preheader.new.i ]
  %.77.013.i.ph = phi ptr [ %scevgep54, %.89.endif.i.prol.loopexit ], [ %.6.i.i39, %.89.endif.preheader.new.i ]
  %.72.012.i.ph = phi double [ %.108.7.i.prol, %.89.endif.i.prol.loopexit ], [ 0.000000e+00, %.89.endif.preheader.new.i ]
  br label %.89.endif.i

common.ret.loopexit.unr-lcssa.i:                  ; preds = %.89.endif.i, %.89.endif.i.prol.loopexit
  %.108.7.i.lcssa = phi double [ %.108.7.i.prol, %.89.endif.i.prol.loopexit ], [ %.108.7.i.3, %.89.endif.i ]
  %.114.7.i.lcssa = phi ptr [ %scevgep54, %.89.endif.i.prol.loopexit ], [ %.114.7.i.3, %.89.endif.i ]
  %lcmp.mod.not.i = icmp eq i64 %xtraiter.i, 0
  br i1 %lcmp.mod.not.i, label %B642.endif, label %.89.endif.epil.preheader.i, !prof !114

.89.endif.epil.preheader.i:                       ; preds = %common.ret.loopexit.unr-lcssa.i, %.89.endif.preheader.i
  %.77.013.epil.init.i = phi ptr [ %.6.i.i39, %.89.endif.preheader.i ], [ %.114.7.i.lcssa, %common.ret.loopexit.unr-lcssa.i ]
  %.72.012.epil.init.i = phi double [ 0.000000e+00, %.89.endif.preheader.i ], [ %.108.7.i.lcssa, %common.ret.loopexit.unr-lcssa.i ]
  br label %.89.endif.epil.i

.89.endif.epil.i:                                 ; preds = %.89.endif.epil.i, %.89.endif.epil.preheader.i
  %.72.012.epil.i = phi double [ %.108.epil.i, %.89.endif.epil.i ], [ %.72.012.epil.init.i, %.89.endif.epil.preheader.i ]
  %epil.iter.i = phi i64 [ %epil.iter.next.i, %.89.endif.epil.i ], [ 0, %.89.endif.epil.preheader.i ]
  %16 = shl i64 %epil.iter.i, 3
  %scevgep237 = getelementptr i8, ptr %.77.013.epil.init.i, i64 %16
  %.106.epil.i = load double, ptr %scevgep237, align 8, !noalias !108
  %.108.epil.i = fadd double %.72.012.epil.i, %.106.epil.i
  %epil.iter.next.i = add i64 %epil.iter.i, 1
  %epil.iter.cmp.not.i = icmp eq i64 %xtraiter.i, %epil.iter.next.i
  br i1 %epil.iter.cmp.not.i, label %B642.endif, label %.89.endif.epil.i, !prof !115, !llvm.loop !116

.89.endif.i:                                      ; preds = %.89.endif.i.preheader, %.89.endif.i
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i.3, %.89.endif.i ], [ %lsr.iv.i.ph, %.89.endif.i.preheader ]
  %.77.013.i = phi ptr [ %.114.7.i.3, %.89.endif.i ], [ %.77.013.i.ph, %.89.endif.i.preheader ]
  %.72.012.i = phi double [ %.108.7.i.3, %.89.endif.i ], [ %.72.012.i.ph, %.89.endif.i.preheader ]
  %.106.i = load double, ptr %.77.013.i, align 8, !noalias !108
  %.108.i = fadd double %.72.012.i, %.106.i
  %.114.i = getelementptr i8, ptr %.77.013.i, i64 8
  %.106.1.i = load double, ptr %.114.i, align 8, !noalias !108
  %.108.1.i = fadd double %.108.i, %.106.1.i
  %.114.1.i = getelementptr i8, ptr %.77.013.i, i64 16
  %.106.2.i = load double, ptr %.114.1.i, align 8, !noalias !108
  %.108.2.i = fadd double %.108.1.i, %.106.2.i
  %.114.2.i = getelementptr i8, ptr %.77.013.i, i64 24
  %.106.3.i = load double, ptr %.114.2.i, align 8, !noalias !108
  %.108.3.i = fadd double %.108.2.i, %.106.3.i
  %.114.3.i = getelementptr i8, ptr %.77.013.i, i64 32
  %.106.4.i = load double, ptr %.114.3.i, align 8, !noalias !108
  %.108.4.i = fadd double %.108.3.i, %.106.4.i
  %.114.4.i = getelementptr i8, ptr %.77.013.i, i64 40
  %.106.5.i = load double, ptr %.114.4.i, align 8, !noalias !108
  %.108.5.i = fadd double %.108.4.i, %.106.5.i
  %.114.5.i = getelementptr i8, ptr %.77.013.i, i64 48
  %.106.6.i = load double, ptr %.114.5.i, align 8, !noalias !108
  %.108.6.i = fadd double %.108.5.i, %.106.6.i
  %.114.6.i = getelementptr i8, ptr %.77.013.i, i64 56
  %.106.7.i = load double, ptr %.114.6.i, align 8, !noalias !108
  %.108.7.i = fadd double %.108.6.i, %.106.7.i
  %.114.7.i = getelementptr i8, ptr %.77.013.i, i64 64
  %.106.i.1 = load double, ptr %.114.7.i, align 8, !noalias !108
  %.108.i.1 = fadd double %.108.7.i, %.106.i.1
  %.114.i.1 = getelementptr i8, ptr %.77.013.i, i64 72
  %.106.1.i.1 = load double, ptr %.114.i.1, align 8, !noalias !108
  %.108.1.i.1 = fadd double %.108.i.1, %.106.1.i.1
  %.114.1.i.1 = getelementptr i8, ptr %.77.013.i, i64 80
  %.106.2.i.1 = load double, ptr %.114.1.i.1, align 8, !noalias !108
  %.108.2.i.1 = fadd double %.108.1.i.1, %.106.2.i.1
  %.114.2.i.1 = getelementptr i8, ptr %.77.013.i, i64 88
  %.106.3.i.1 = load double, ptr %.114.2.i.1, align 8, !noalias !108
  %.108.3.i.1 = fadd double %.108.2.i.1, %.106.3.i.1
  %.114.3.i.1 = getelementptr i8, ptr %.77.013.i, i64 96
  %.106.4.i.1 = load double, ptr %.114.3.i.1, align 8, !noalias !108
  %.108.4.i.1 = fadd double %.108.3.i.1, %.106.4.i.1
  %.114.4.i.1 = getelementptr i8, ptr %.77.013.i, i64 104
  %.106.5.i.1 = load double, ptr %.114.4.i.1, align 8, !noalias !108
  %.108.5.i.1 = fadd double %.108.4.i.1, %.106.5.i.1
  %.114.5.i.1 = getelementptr i8, ptr %.77.013.i, i64 112
  %.106.6.i.1 = load double, ptr %.114.5.i.1, align 8, !noalias !108
  %.108.6.i.1 = fadd double %.108.5.i.1, %.106.6.i.1
  %.114.6.i.1 = getelementptr i8, ptr %.77.013.i, i64 120
  %.106.7.i.1 = load double, ptr %.114.6.i.1, align 8, !noalias !108
  %.108.7.i.1 = fadd double %.108.6.i.1, %.106.7.i.1
  %.114.7.i.1 = getelementptr i8, ptr %.77.013.i, i64 128
  %.106.i.2 = load double, ptr %.114.7.i.1, align 8, !noalias !108
  %.108.i.2 = fadd double %.108.7.i.1, %.106.i.2
  %.114.i.2 = getelementptr i8, ptr %.77.013.i, i64 136
  %.106.1.i.2 = load double, ptr %.114.i.2, align 8, !noalias !108
  %.108.1.i.2 = fadd double %.108.i.2, %.106.1.i.2
  %.114.1.i.2 = getelementptr i8, ptr %.77.013.i, i64 144
  %.106.2.i.2 = load double, ptr %.114.1.i.2, align 8, !noalias !108
  %.108.2.i.2 = fadd double %.108.1.i.2, %.106.2.i.2
  %.114.2.i.2 = getelementptr i8, ptr %.77.013.i, i64 152
  %.106.3.i.2 = load double, ptr %.114.2.i.2, align 8, !noalias !108
  %.108.3.i.2 = fadd double %.108.2.i.2, %.106.3.i.2
  %.114.3.i.2 = getelementptr i8, ptr %.77.013.i, i64 160
  %.106.4.i.2 = load double, ptr %.114.3.i.2, align 8, !noalias !108
  %.108.4.i.2 = fadd double %.108.3.i.2, %.106.4.i.2
  %.114.4.i.2 = getelementptr i8, ptr %.77.013.i, i64 168
  %.106.5.i.2 = load double, ptr %.114.4.i.2, align 8, !noalias !108
  %.108.5.i.2 = fadd double %.108.4.i.2, %.106.5.i.2
  %.114.5.i.2 = getelementptr i8, ptr %.77.013.i, i64 176
  %.106.6.i.2 = load double, ptr %.114.5.i.2, align 8, !noalias !108
  %.108.6.i.2 = fadd double %.108.5.i.2, %.106.6.i.2
  %.114.6.i.2 = getelementptr i8, ptr %.77.013.i, i64 184
  %.106.7.i.2 = load double, ptr %.114.6.i.2, align 8, !noalias !108
  %.108.7.i.2 = fadd double %.108.6.i.2, %.106.7.i.2
  %.114.7.i.2 = getelementptr i8, ptr %.77.013.i, i64 192
  %.106.i.3 = load double, ptr %.114.7.i.2, align 8, !noalias !108
  %.108.i.3 = fadd double %.108.7.i.2, %.106.i.3
  %.114.i.3 = getelementptr i8, ptr %.77.013.i, i64 200
  %.106.1.i.3 = load double, ptr %.114.i.3, align 8, !noalias !108
  %.108.1.i.3 = fadd double %.108.i.3, %.106.1.i.3
  %.114.1.i.3 = getelementptr i8, ptr %.77.013.i, i64 208
  %.106.2.i.3 = load double, ptr %.114.1.i.3, align 8, !noalias !108
  %.108.2.i.3 = fadd double %.108.1.i.3, %.106.2.i.3
  %.114.2.i.3 = getelementptr i8, ptr %.77.013.i, i64 216
  %.106.3.i.3 = load double, ptr %.114.2.i.3, align 8, !noalias !108
  %.108.3.i.3 = fadd double %.108.2.i.3, %.106.3.i.3
  %.114.3.i.3 = getelementptr i8, ptr %.77.013.i, i64 224
  %.106.4.i.3 = load double, ptr %.114.3.i.3, align 8, !noalias !108
  %.108.4.i.3 = fadd double %.108.3.i.3, %.106.4.i.3
  %.114.4.i.3 = getelementptr i8, ptr %.77.013.i, i64 232
  %.106.5.i.3 = load double, ptr %.114.4.i.3, align 8, !noalias !108
  %.108.5.i.3 = fadd double %.108.4.i.3, %.106.5.i.3
  %.114.5.i.3 = getelementptr i8, ptr %.77.013.i, i64 240
  %.106.6.i.3 = load double, ptr %.114.5.i.3, align 8, !noalias !108
  %.108.6.i.3 = fadd double %.108.5.i.3, %.106.6.i.3
  %.114.6.i.3 = getelementptr i8, ptr %.77.013.i, i64 248
  %.106.7.i.3 = load double, ptr %.114.6.i.3, align 8, !noalias !108
  %.108.7.i.3 = fadd double %.108.6.i.3, %.106.7.i.3
  %.114.7.i.3 = getelementptr i8, ptr %.77.013.i, i64 256
  %lsr.iv.next.i.3 = add nsw i64 %lsr.iv.i, -32
  %niter.ncmp.7.i.3 = icmp eq i64 %lsr.iv.next.i.3, 0
  br i1 %niter.ncmp.7.i.3, label %common.ret.loopexit.unr-lcssa.i, label %.89.endif.i, !prof !118, !llvm.loop !119

B0.endif.endif.endif.i12:                         ; preds = %B0.endif.endif.endif.i
  %.5.i.i = getelementptr i8, ptr %.7.i.i.i, i64 24
  %.6.i.i = load ptr, ptr %.5.i.i, align 8, !noalias !121
  %.7.i.i.i14 = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.29.i, i32 32), !noalias !122
  %.8.i.i.i15 = icmp eq ptr %.7.i.i.i14, null
  br i1 %.8.i.i.i15, label %B0.endif.if.if, label %B0.endif.endif.endif.i33, !prof !11

common.ret:                                       ; preds = %for.end.3.endif.endif.endif, %for.end.endif.endif.endif.endif.endif.endif.if.if, %B642.endif.endif.endif.endif.endif.endif.endif.if.if, %B642.endif.if.if, %B260.endif.if.if, %B0.endif.endif.endif.endif.if.if, %B0.endif.endif.endif.if.if, %B0.endif.endif.if.if, %B0.endif.if.if, %B0.if.if
  %common.ret.op = phi i32 [ 1, %B0.if.if ], [ 1, %B0.endif.if.if ], [ 1, %B0.endif.endif.if.if ], [ 1, %B0.endif.endif.endif.if.if ], [ 1, %B0.endif.endif.endif.endif.if.if ], [ %.441, %B260.endif.if.if ], [ 0, %for.end.3.endif.endif.endif ], [ 1, %B642.endif.if.if ], [ 1, %for.end.endif.endif.endif.endif.endif.endif.if.if ], [ 1, %B642.endif.endif.endif.endif.endif.endif.endif.if.if ]
  ret i32 %common.ret.op

B0.if.if:                                         ; preds = %B0.endif.endif.endif.i, %B0.endif.endif.i, %B0
  %excinfo.1.0.ph = phi ptr [ @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.19, %B0.endif.endif.endif.i ], [ @.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57.3, %B0.endif.endif.i ], [ @.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b.20, %B0 ]
  store ptr %excinfo.1.0.ph, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.i33:                         ; preds = %B0.endif.endif.endif.i12
  %.5.i.i17 = getelementptr i8, ptr %.7.i.i.i14, i64 24
  %.6.i.i18 = load ptr, ptr %.5.i.i17, align 8, !noalias !132
  %.7.i.i.i35 = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.29.i, i32 32), !noalias !133
  %.8.i.i.i36 = icmp eq ptr %.7.i.i.i35, null
  br i1 %.8.i.i.i36, label %B0.endif.endif.if.if, label %B0.endif.endif.endif.i54, !prof !11

B0.endif.if.if:                                   ; preds = %B0.endif.endif.endif.i12
  store ptr @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.19, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.i54:                         ; preds = %B0.endif.endif.endif.i33
  %.5.i.i38 = getelementptr i8, ptr %.7.i.i.i35, i64 24
  %.6.i.i39 = load ptr, ptr %.5.i.i38, align 8, !noalias !143
  %.7.i.i.i56 = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.29.i, i32 32), !noalias !144
  %.8.i.i.i57 = icmp eq ptr %.7.i.i.i56, null
  br i1 %.8.i.i.i57, label %B0.endif.endif.endif.if.if, label %B0.endif.endif.endif.i75, !prof !11

B0.endif.endif.if.if:                             ; preds = %B0.endif.endif.endif.i33
  store ptr @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.19, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.i75:                         ; preds = %B0.endif.endif.endif.i54
  %.5.i.i59 = getelementptr i8, ptr %.7.i.i.i56, i64 24
  %.6.i.i60 = load ptr, ptr %.5.i.i59, align 8, !noalias !154
  %.7.i.i.i77 = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.29.i, i32 32), !noalias !155
  %.8.i.i.i78 = icmp eq ptr %.7.i.i.i77, null
  br i1 %.8.i.i.i78, label %B0.endif.endif.endif.endif.if.if, label %B0.endif.endif.endif.endif.endif.endif, !prof !11

B0.endif.endif.endif.if.if:                       ; preds = %B0.endif.endif.endif.i54
  store ptr @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.19, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif.if.if:                 ; preds = %B0.endif.endif.endif.i75
  store ptr @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.19, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif.endif.endif:           ; preds = %B0.endif.endif.endif.i75
  %.5.i.i80 = getelementptr i8, ptr %.7.i.i.i77, i64 24
  %.6.i.i81 = load ptr, ptr %.5.i.i80, align 8, !noalias !165
  %.352665.not = icmp eq i64 %.99.fca.5.0.load.fr349, 0
  br i1 %.352665.not, label %B642.thread, label %B260.lr.ph

B642.thread:                                      ; preds = %B0.endif.endif.endif.endif.endif.endif
  tail call void @NRT_incref(ptr nonnull %.7.i.i.i35)
  br label %B642.endif

B260.lr.ph:                                       ; preds = %B0.endif.endif.endif.endif.endif.endif
  %.492 = fneg double %arg.dt
  br label %B260

B260.endif.endif:                                 ; preds = %B260, %B260
  %.483 = fcmp olt double %.451.fca.0.load, 5.000000e-01
  br i1 %.483, label %B340, label %B350

B260.endif.if.if:                                 ; preds = %B260
  store ptr null, ptr %excinfo, align 8
  br label %common.ret

B642.endif:                                       ; preds = %.89.endif.epil.i, %B642.thread, %common.ret.loopexit.unr-lcssa.i
  %.72.0.lcssa.i = phi double [ 0.000000e+00, %B642.thread ], [ %.108.7.i.lcssa, %common.ret.loopexit.unr-lcssa.i ], [ %.108.epil.i, %.89.endif.epil.i ]
  tail call void @NRT_incref(ptr nonnull %.7.i.i.i77)
  store double 0.000000e+00, ptr %.943, align 8
  %.949 = call i32 @_ZN5numba2np9arraymath7npy_max12_3clocals_3e8impl_maxB3v18B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE(ptr nonnull %.943, ptr nonnull %excinfo.8, ptr nonnull %.7.i.i.i77, ptr null, i64 %.99.fca.5.0.load.fr349, i64 8, ptr %.6.i.i81, i64 %.99.fca.5.0.load.fr349, i64 8)
  %.959 = load double, ptr %.943, align 8
  %cond5 = icmp eq i32 %.949, 0
  tail call void @NRT_decref(ptr nonnull %.7.i.i.i35)
  br i1 %cond5, label %B128.i, label %B642.endif.if.if, !prof !0

B128.i:                                           ; preds = %B642.endif
  tail call void @NRT_decref(ptr nonnull %.7.i.i.i77)
  %.7.i.i = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.29.i, i32 32), !noalias !166
  %.8.i.i = icmp eq ptr %.7.i.i, null
  br i1 %.8.i.i, label %B642.endif.endif.endif.endif.endif.endif.endif.if.if, label %B642.endif.endif.endif.endif.endif.endif.endif.endif, !prof !11

B642.endif.if.if:                                 ; preds = %B642.endif
  %.950 = load ptr, ptr %excinfo.8, align 8
  store ptr %.950, ptr %excinfo, align 8
  br label %common.ret

B642.endif.endif.endif.endif.endif.endif.endif.endif: ; preds = %B128.i
  %.5.i = getelementptr i8, ptr %.7.i.i, i64 24
  %.6.i = load ptr, ptr %.5.i, align 8
  switch i64 %.99.fca.5.0.load.fr349, label %for.body.endif.endif.endif.us.preheader [
    i64 0, label %B128.i187
    i64 1, label %.89.endif.preheader.i122.thread16
  ]

for.body.endif.endif.endif.us.preheader:          ; preds = %B642.endif.endif.endif.endif.endif.endif.endif.endif
  %min.iters.check = icmp ult i64 %.99.fca.5.0.load.fr349, 8
  br i1 %min.iters.check, label %for.body.endif.endif.endif.us.preheader551, label %vector.memcheck

vector.memcheck:                                  ; preds = %for.body.endif.endif.endif.us.preheader
  %17 = ptrtoint ptr %.6.i to i64
  %18 = ptrtoint ptr %.6.i.i81 to i64
  %19 = ptrtoint ptr %.6.i.i60 to i64
  %20 = sub i64 %17, %18
  %diff.check = icmp ult i64 %20, 64
  %21 = sub i64 %17, %19
  %diff.check443 = icmp ult i64 %21, 64
  %conflict.rdx = or i1 %diff.check, %diff.check443
  br i1 %conflict.rdx, label %for.body.endif.endif.endif.us.preheader551, label %vector.ph

vector.ph:                                        ; preds = %vector.memcheck
  %n.vec = and i64 %.99.fca.5.0.load.fr349, %const
  %broadcast.splatinsert = insertelement <8 x double> poison, double %.959, i64 0
  %broadcast.splat = shufflevector <8 x double> %broadcast.splatinsert, <8 x double> poison, <8 x i32> zeroinitializer
  br label %vector.body

vector.body:                                      ; preds = %vector.body, %vector.ph
  %index = phi i64 [ 0, %vector.ph ], [ %index.next, %vector.body ]
  %22 = shl i64 %index, 3
  %scevgep236 = getelementptr i8, ptr %.6.i.i81, i64 %22
  %wide.load = load <8 x double>, ptr %scevgep236, align 8
  %23 = shl i64 %index, 3
  %scevgep235 = getelementptr i8, ptr %.6.i.i60, i64 %23
  %wide.load444 = load <8 x double>, ptr %scevgep235, align 8
  %24 = fdiv <8 x double> %wide.load, %broadcast.splat
  %25 = fsub <8 x double> splat (double 1.000000e+00), %24
  %26 = fmul <8 x double> %wide.load444, %25
  %27 = shl i64 %index, 3
  %scevgep234 = getelementptr i8, ptr %.6.i, i64 %27
  store <8 x double> %26, ptr %scevgep234, align 8
  %index.next = add nuw i64 %index, 8
  %28 = icmp eq i64 %n.vec, %index.next
  br i1 %28, label %middle.block, label %vector.body, !llvm.loop !173

middle.block:                                     ; preds = %vector.body
  %cmp.n = icmp eq i64 %.99.fca.5.0.load.fr349, %n.vec
  br i1 %cmp.n, label %middle.block..89.endif.preheader.i122.thread_crit_edge, label %for.body.endif.endif.endif.us.preheader551

middle.block..89.endif.preheader.i122.thread_crit_edge: ; preds = %middle.block
  %.pre = and i64 %.99.fca.5.0.load.fr349, 7
  br label %.89.endif.preheader.new.i124

for.body.endif.endif.endif.us.preheader551:       ; preds = %middle.block, %vector.memcheck, %for.body.endif.endif.endif.us.preheader
  %loop.index672.us.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %for.body.endif.endif.endif.us.preheader ], [ %n.vec, %middle.block ]
  %xtraiter553 = and i64 %.99.fca.5.0.load.fr349, 7
  %lcmp.mod554.not = icmp eq i64 %xtraiter553, 0
  br i1 %lcmp.mod554.not, label %for.body.endif.endif.endif.us.prol.loopexit, label %for.body.endif.endif.endif.us.prol.preheader

for.body.endif.endif.endif.us.prol.preheader:     ; preds = %for.body.endif.endif.endif.us.preheader551
  br label %for.body.endif.endif.endif.us.prol

for.body.endif.endif.endif.us.prol:               ; preds = %for.body.endif.endif.endif.us.prol.preheader, %for.body.endif.endif.endif.us.prol
  %lsr.iv232 = phi i64 [ %xtraiter553, %for.body.endif.endif.endif.us.prol.preheader ], [ %lsr.iv.next233, %for.body.endif.endif.endif.us.prol ]
  %loop.index672.us.prol = phi i64 [ %.1202.us.prol, %for.body.endif.endif.endif.us.prol ], [ %loop.index672.us.ph, %for.body.endif.endif.endif.us.prol.preheader ]
  %29 = shl nuw nsw i64 %loop.index672.us.prol, 3
  %scevgep231 = getelementptr i8, ptr %.6.i.i81, i64 %29
  %.1164.us.prol = load double, ptr %scevgep231, align 8
  %30 = shl nuw nsw i64 %loop.index672.us.prol, 3
  %scevgep230 = getelementptr i8, ptr %.6.i.i60, i64 %30
  %.1173.us.prol = load double, ptr %scevgep230, align 8
  %.10.i.prol = fdiv double %.1164.us.prol, %.959
  %.11.i.prol = fsub double 1.000000e+00, %.10.i.prol
  %.12.i.prol = fmul double %.1173.us.prol, %.11.i.prol
  %31 = shl nuw nsw i64 %loop.index672.us.prol, 3
  %scevgep229 = getelementptr i8, ptr %.6.i, i64 %31
  store double %.12.i.prol, ptr %scevgep229, align 8
  %.1202.us.prol = add nuw nsw i64 %loop.index672.us.prol, 1
  %lsr.iv.next233 = add nsw i64 %lsr.iv232, -1
  %prol.iter555.cmp.not = icmp eq i64 %lsr.iv.next233, 0
  br i1 %prol.iter555.cmp.not, label %for.body.endif.endif.endif.us.prol.loopexit, label %for.body.endif.endif.endif.us.prol, !llvm.loop !174

for.body.endif.endif.endif.us.prol.loopexit:      ; preds = %for.body.endif.endif.endif.us.prol, %for.body.endif.endif.endif.us.preheader551
  %loop.index672.us.unr = phi i64 [ %loop.index672.us.ph, %for.body.endif.endif.endif.us.preheader551 ], [ %.1202.us.prol, %for.body.endif.endif.endif.us.prol ]
  %32 = sub nsw i64 %loop.index672.us.ph, %.99.fca.5.0.load.fr349
  %33 = icmp ugt i64 %32, -8
  br i1 %33, label %.89.endif.preheader.i122, label %for.body.endif.endif.endif.us.preheader70

for.body.endif.endif.endif.us.preheader70:        ; preds = %for.body.endif.endif.endif.us.prol.loopexit
  br label %for.body.endif.endif.endif.us

for.body.endif.endif.endif.us:                    ; preds = %for.body.endif.endif.endif.us.preheader70, %for.body.endif.endif.endif.us
  %loop.index672.us = phi i64 [ %.1202.us.7, %for.body.endif.endif.endif.us ], [ %loop.index672.us.unr, %for.body.endif.endif.endif.us.preheader70 ]
  %sunkaddr254 = mul i64 %loop.index672.us, 8
  %sunkaddr255 = getelementptr i8, ptr %.6.i.i81, i64 %sunkaddr254
  %.1164.us = load double, ptr %sunkaddr255, align 8
  %sunkaddr256 = mul i64 %loop.index672.us, 8
  %sunkaddr257 = getelementptr i8, ptr %.6.i.i60, i64 %sunkaddr256
  %.1173.us = load double, ptr %sunkaddr257, align 8
  %.10.i = fdiv double %.1164.us, %.959
  %.11.i = fsub double 1.000000e+00, %.10.i
  %.12.i = fmul double %.1173.us, %.11.i
  %sunkaddr258 = mul i64 %loop.index672.us, 8
  %sunkaddr259 = getelementptr i8, ptr %.6.i, i64 %sunkaddr258
  store double %.12.i, ptr %sunkaddr259, align 8
  %sunkaddr260 = mul i64 %loop.index672.us, 8
  %sunkaddr261 = getelementptr i8, ptr %.6.i.i81, i64 %sunkaddr260
  %sunkaddr262 = getelementptr i8, ptr %sunkaddr261, i64 8
  %.1164.us.1 = load double, ptr %sunkaddr262, align 8
  %sunkaddr263 = mul i64 %loop.index672.us, 8
  %sunkaddr264 = getelementptr i8, ptr %.6.i.i60, i64 %sunkaddr263
  %sunkaddr265 = getelementptr i8, ptr %sunkaddr264, i64 8
  %.1173.us.1 = load double, ptr %sunkaddr265, align 8
  %.10.i.1 = fdiv double %.1164.us.1, %.959
  %.11.i.1 = fsub double 1.000000e+00, %.10.i.1
  %.12.i.1 = fmul double %.1173.us.1, %.11.i.1
  %sunkaddr266 = mul i64 %loop.index672.us, 8
  %sunkaddr267 = getelementptr i8, ptr %.6.i, i64 %sunkaddr266
  %sunkaddr268 = getelementptr i8, ptr %sunkaddr267, i64 8
  store double %.12.i.1, ptr %sunkaddr268, align 8
  %sunkaddr269 = mul i64 %loop.index672.us, 8
  %sunkaddr270 = getelementptr i8, ptr %.6.i.i81, i64 %sunkaddr269
  %sunkaddr271 = getelementptr i8, ptr %sunkaddr270, i64 16
  %.1164.us.2 = load double, ptr %sunkaddr271, align 8
  %sunkaddr272 = mul i64 %loop.index672.us, 8
  %sunkaddr273 = getelementptr i8, ptr %.6.i.i60, i64 %sunkaddr272
  %sunkaddr274 = getelementptr i8, ptr %sunkaddr273, i64 16
  %.1173.us.2 = load double, ptr %sunkaddr274, align 8
  %.10.i.2 = fdiv double %.1164.us.2, %.959
  %.11.i.2 = fsub double 1.000000e+00, %.10.i.2
  %.12.i.2 = fmul double %.1173.us.2, %.11.i.2
  %sunkaddr275 = mul i64 %loop.index672.us, 8
  %sunkaddr276 = getelementptr i8, ptr %.6.i, i64 %sunkaddr275
  %sunkaddr277 = getelementptr i8, ptr %sunkaddr276, i64 16
  store double %.12.i.2, ptr %sunkaddr277, align 8
  %sunkaddr278 = mul i64 %loop.index672.us, 8
  %sunkaddr279 = getelementptr i8, ptr %.6.i.i81, i64 %sunkaddr278
  %sunkaddr280 = getelementptr i8, ptr %sunkaddr279, i64 24
  %.1164.us.3 = load double, ptr %sunkaddr280, align 8
  %sunkaddr281 = mul i64 %loop.index672.us, 8
  %sunkaddr282 = getelementptr i8, ptr %.6.i.i60, i64 %sunkaddr281
  %sunkaddr283 = getelementptr i8, ptr %sunkaddr282, i64 24
  %.1173.us.3 = load double, ptr %sunkaddr283, align 8
  %.10.i.3 = fdiv double %.1164.us.3, %.959
  %.11.i.3 = fsub double 1.000000e+00, %.10.i.3
  %.12.i.3 = fmul double %.1173.us.3, %.11.i.3
  %sunkaddr284 = mul i64 %loop.index672.us, 8
  %sunkaddr285 = getelementptr i8, ptr %.6.i, i64 %sunkaddr284
  %sunkaddr286 = getelementptr i8, ptr %sunkaddr285, i64 24
  store double %.12.i.3, ptr %sunkaddr286, align 8
  %sunkaddr287 = mul i64 %loop.index672.us, 8
  %sunkaddr288 = getelementptr i8, ptr %.6.i.i81, i64 %sunkaddr287
  %sunkaddr289 = getelementptr i8, ptr %sunkaddr288, i64 32
  %.1164.us.4 = load double, ptr %sunkaddr289, align 8
  %sunkaddr290 = mul i64 %loop.index672.us, 8
  %sunkaddr291 = getelementptr i8, ptr %.6.i.i60, i64 %sunkaddr290
  %sunkaddr292 = getelementptr i8, ptr %sunkaddr291, i64 32
  %.1173.us.4 = load double, ptr %sunkaddr292, align 8
  %.10.i.4 = fdiv double %.1164.us.4, %.959
  %.11.i.4 = fsub double 1.000000e+00, %.10.i.4
  %.12.i.4 = fmul double %.1173.us.4, %.11.i.4
  %sunkaddr293 = mul i64 %loop.index672.us, 8
  %sunkaddr294 = getelementptr i8, ptr %.6.i, i64 %sunkaddr293
  %sunkaddr295 = getelementptr i8, ptr %sunkaddr294, i64 32
  store double %.12.i.4, ptr %sunkaddr295, align 8
  %sunkaddr296 = mul i64 %loop.index672.us, 8
  %sunkaddr297 = getelementptr i8, ptr %.6.i.i81, i64 %sunkaddr296
  %sunkaddr298 = getelementptr i8, ptr %sunkaddr297, i64 40
  %.1164.us.5 = load double, ptr %sunkaddr298, align 8
  %sunkaddr299 = mul i64 %loop.index672.us, 8
  %sunkaddr300 = getelementptr i8, ptr %.6.i.i60, i64 %sunkaddr299
  %sunkaddr301 = getelementptr i8, ptr %sunkaddr300, i64 40
  %.1173.us.5 = load double, ptr %sunkaddr301, align 8
  %.10.i.5 = fdiv double %.1164.us.5, %.959
  %.11.i.5 = fsub double 1.000000e+00, %.10.i.5
  %.12.i.5 = fmul double %.1173.us.5, %.11.i.5
  %sunkaddr302 = mul i64 %loop.index672.us, 8
  %sunkaddr303 = getelementptr i8, ptr %.6.i, i64 %sunkaddr302
  %sunkaddr304 = getelementptr i8, ptr %sunkaddr303, i64 40
  store double %.12.i.5, ptr %sunkaddr304, align 8
  %sunkaddr305 = mul i64 %loop.index672.us, 8
  %sunkaddr306 = getelementptr i8, ptr %.6.i.i81, i64 %sunkaddr305
  %sunkaddr307 = getelementptr i8, ptr %sunkaddr306, i64 48
  %.1164.us.6 = load double, ptr %sunkaddr307, align 8
  %sunkaddr308 = mul i64 %loop.index672.us, 8
  %sunkaddr309 = getelementptr i8, ptr %.6.i.i60, i64 %sunkaddr308
  %sunkaddr310 = getelementptr i8, ptr %sunkaddr309, i64 48
  %.1173.us.6 = load double, ptr %sunkaddr310, align 8
  %.10.i.6 = fdiv double %.1164.us.6, %.959
  %.11.i.6 = fsub double 1.000000e+00, %.10.i.6
  %.12.i.6 = fmul double %.1173.us.6, %.11.i.6
  %sunkaddr311 = mul i64 %loop.index672.us, 8
  %sunkaddr312 = getelementptr i8, ptr %.6.i, i64 %sunkaddr311
  %sunkaddr313 = getelementptr i8, ptr %sunkaddr312, i64 48
  store double %.12.i.6, ptr %sunkaddr313, align 8
  %sunkaddr314 = mul i64 %loop.index672.us, 8
  %sunkaddr315 = getelementptr i8, ptr %.6.i.i81, i64 %sunkaddr314
  %sunkaddr316 = getelementptr i8, ptr %sunkaddr315, i64 56
  %.1164.us.7 = load double, ptr %sunkaddr316, align 8
  %sunkaddr317 = mul i64 %loop.index672.us, 8
  %sunkaddr318 = getelementptr i8, ptr %.6.i.i60, i64 %sunkaddr317
  %sunkaddr319 = getelementptr i8, ptr %sunkaddr318, i64 56
  %.1173.us.7 = load double, ptr %sunkaddr319, align 8
  %.10.i.7 = fdiv double %.1164.us.7, %.959
  %.11.i.7 = fsub double 1.000000e+00, %.10.i.7
  %.12.i.7 = fmul double %.1173.us.7, %.11.i.7
  %sunkaddr320 = mul i64 %loop.index672.us, 8
  %sunkaddr321 = getelementptr i8, ptr %.6.i, i64 %sunkaddr320
  %sunkaddr322 = getelementptr i8, ptr %sunkaddr321, i64 56
  store double %.12.i.7, ptr %sunkaddr322, align 8
  %.1202.us.7 = add nuw nsw i64 %loop.index672.us, 8
  %exitcond710.not.7 = icmp eq i64 %.99.fca.5.0.load.fr349, %.1202.us.7
  br i1 %exitcond710.not.7, label %.89.endif.preheader.new.i124, label %for.body.endif.endif.endif.us, !llvm.loop !175

B642.endif.endif.endif.endif.endif.endif.endif.if.if: ; preds = %B128.i
  store ptr @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.22, ptr %excinfo, align 8
  br label %common.ret

.89.endif.preheader.i122:                         ; preds = %for.body.endif.endif.endif.us.prol.loopexit
  %34 = icmp ult i64 %.99.fca.5.0.load.fr349, 8
  br i1 %34, label %.89.endif.epil.preheader.i158, label %.89.endif.preheader.new.i124, !prof !176

.89.endif.preheader.new.i124:                     ; preds = %for.body.endif.endif.endif.us, %middle.block..89.endif.preheader.i122.thread_crit_edge, %.89.endif.preheader.i122
  %xtraiter.i12314 = phi i64 [ %xtraiter553, %.89.endif.preheader.i122 ], [ %.pre, %middle.block..89.endif.preheader.i122.thread_crit_edge ], [ %xtraiter553, %for.body.endif.endif.endif.us ]
  %unroll_iter.i125 = and i64 %.99.fca.5.0.load.fr349, %const
  %35 = add nsw i64 %.99.fca.5.0.load.fr349, -8
  %36 = lshr i64 %35, 3
  %37 = add nuw nsw i64 %36, 1
  %xtraiter556 = and i64 %37, 3
  %38 = and i64 %35, 24
  %lcmp.mod557.not = icmp eq i64 %38, 24
  br i1 %lcmp.mod557.not, label %.89.endif.i126.preheader, label %.89.endif.i126.prol.preheader, !prof !107

.89.endif.i126.prol.preheader:                    ; preds = %.89.endif.preheader.new.i124
  br label %.89.endif.i126.prol

.89.endif.i126.prol:                              ; preds = %.89.endif.i126.prol.preheader, %.89.endif.i126.prol
  %lsr.iv179 = phi i64 [ %xtraiter556, %.89.endif.i126.prol.preheader ], [ %lsr.iv.next180, %.89.endif.i126.prol ]
  %.77.013.i128.prol = phi ptr [ %.114.7.i153.prol, %.89.endif.i126.prol ], [ %.6.i, %.89.endif.i126.prol.preheader ]
  %.72.012.i129.prol = phi double [ %.108.7.i152.prol, %.89.endif.i126.prol ], [ 0.000000e+00, %.89.endif.i126.prol.preheader ]
  %.106.i130.prol = load double, ptr %.77.013.i128.prol, align 8, !noalias !177
  %.108.i131.prol = fadd double %.72.012.i129.prol, %.106.i130.prol
  %.114.i132.prol = getelementptr i8, ptr %.77.013.i128.prol, i64 8
  %.106.1.i133.prol = load double, ptr %.114.i132.prol, align 8, !noalias !177
  %.108.1.i134.prol = fadd double %.108.i131.prol, %.106.1.i133.prol
  %.114.1.i135.prol = getelementptr i8, ptr %.77.013.i128.prol, i64 16
  %.106.2.i136.prol = load double, ptr %.114.1.i135.prol, align 8, !noalias !177
  %.108.2.i137.prol = fadd double %.108.1.i134.prol, %.106.2.i136.prol
  %.114.2.i138.prol = getelementptr i8, ptr %.77.013.i128.prol, i64 24
  %.106.3.i139.prol = load double, ptr %.114.2.i138.prol, align 8, !noalias !177
  %.108.3.i140.prol = fadd double %.108.2.i137.prol, %.106.3.i139.prol
  %.114.3.i141.prol = getelementptr i8, ptr %.77.013.i128.prol, i64 32
  %.106.4.i142.prol = load double, ptr %.114.3.i141.prol, align 8, !noalias !177
  %.108.4.i143.prol = fadd double %.108.3.i140.prol, %.106.4.i142.prol
  %.114.4.i144.prol = getelementptr i8, ptr %.77.013.i128.prol, i64 40
  %.106.5.i145.prol = load double, ptr %.114.4.i144.prol, align 8, !noalias !177
  %.108.5.i146.prol = fadd double %.108.4.i143.prol, %.106.5.i145.prol
  %.114.5.i147.prol = getelementptr i8, ptr %.77.013.i128.prol, i64 48
  %.106.6.i148.prol = load double, ptr %.114.5.i147.prol, align 8, !noalias !177
  %.108.6.i149.prol = fadd double %.108.5.i146.prol, %.106.6.i148.prol
  %.114.6.i150.prol = getelementptr i8, ptr %.77.013.i128.prol, i64 56
  %.106.7.i151.prol = load double, ptr %.114.6.i150.prol, align 8, !noalias !177
  %.108.7.i152.prol = fadd double %.108.6.i149.prol, %.106.7.i151.prol
  %.114.7.i153.prol = getelementptr i8, ptr %.77.013.i128.prol, i64 64
  %lsr.iv.next180 = add i64 %lsr.iv179, -1
  %prol.iter558.cmp.not = icmp eq i64 %lsr.iv.next180, 0
  br i1 %prol.iter558.cmp.not, label %.89.endif.i126.prol.loopexit, label %.89.endif.i126.prol, !prof !111, !llvm.loop !180

.89.endif.i126.prol.loopexit:                     ; preds = %.89.endif.i126.prol
  %39 = shl nuw nsw i64 %xtraiter556, 6
  %scevgep55 = getelementptr i8, ptr %.6.i, i64 %39
  %40 = shl nuw nsw i64 %xtraiter556, 3
  %41 = sub nsw i64 %unroll_iter.i125, %40
  %42 = icmp ult i64 %35, 24
  br i1 %42, label %common.ret.loopexit.unr-lcssa.i156, label %.89.endif.i126.preheader, !prof !113

.89.endif.i126.preheader:                         ; preds = %.89.endif.preheader.new.i124, %.89.endif.i126.prol.loopexit
  %lsr.iv.i127.ph = phi i64 [ %unroll_iter.i125, %.89.endif.preheader.new.i124 ], [ %41, %.89.endif.i126.prol.loopexit ]
  %.77.013.i128.ph = phi ptr [ %.6.i, %.89.endif.preheader.new.i124 ], [ %scevgep55, %.89.endif.i126.prol.loopexit ]
  %.72.012.i129.ph = phi double [ 0.000000e+00, %.89.endif.preheader.new.i124 ], [ %.108.7.i152.prol, %.89.endif.i126.prol.loopexit ]
  br label %.89.endif.i126

common.ret.loopexit.unr-lcssa.i156:               ; preds = %.89.endif.i126, %.89.endif.i126.prol.loopexit
  %.108.7.i152.lcssa = phi double [ %.108.7.i152.prol, %.89.endif.i126.prol.loopexit ], [ %.108.7.i152.3, %.89.endif.i126 ]
  %.114.7.i153.lcssa = phi ptr [ %scevgep55, %.89.endif.i126.prol.loopexit ], [ %.114.7.i153.3, %.89.endif.i126 ]
  %lcmp.mod.not.i157 = icmp eq i64 %xtraiter.i12314, 0
  br i1 %lcmp.mod.not.i157, label %B128.i187, label %.89.endif.epil.preheader.i158, !prof !114

.89.endif.epil.preheader.i158:                    ; preds = %.89.endif.preheader.i122.thread16, %common.ret.loopexit.unr-lcssa.i156, %.89.endif.preheader.i122
  %xtraiter.i12315 = phi i64 [ %xtraiter553, %.89.endif.preheader.i122 ], [ %xtraiter.i12314, %common.ret.loopexit.unr-lcssa.i156 ], [ 1, %.89.endif.preheader.i122.thread16 ]
  %.77.013.epil.init.i159 = phi ptr [ %.6.i, %.89.endif.preheader.i122 ], [ %.114.7.i153.lcssa, %common.ret.loopexit.unr-lcssa.i156 ], [ %.6.i, %.89.endif.preheader.i122.thread16 ]
  %.72.012.epil.init.i160 = phi double [ 0.000000e+00, %.89.endif.preheader.i122 ], [ %.108.7.i152.lcssa, %common.ret.loopexit.unr-lcssa.i156 ], [ 0.000000e+00, %.89.endif.preheader.i122.thread16 ]
  br label %.89.endif.epil.i161

.89.endif.epil.i161:                              ; preds = %.89.endif.epil.i161, %.89.endif.epil.preheader.i158
  %.72.012.epil.i162 = phi double [ %.108.epil.i166, %.89.endif.epil.i161 ], [ %.72.012.epil.init.i160, %.89.endif.epil.preheader.i158 ]
  %epil.iter.i163 = phi i64 [ %epil.iter.next.i167, %.89.endif.epil.i161 ], [ 0, %.89.endif.epil.preheader.i158 ]
  %43 = shl i64 %epil.iter.i163, 3
  %scevgep178 = getelementptr i8, ptr %.77.013.epil.init.i159, i64 %43
  %.106.epil.i165 = load double, ptr %scevgep178, align 8, !noalias !177
  %.108.epil.i166 = fadd double %.72.012.epil.i162, %.106.epil.i165
  %epil.iter.next.i167 = add i64 %epil.iter.i163, 1
  %epil.iter.cmp.not.i168 = icmp eq i64 %xtraiter.i12315, %epil.iter.next.i167
  br i1 %epil.iter.cmp.not.i168, label %B128.i187, label %.89.endif.epil.i161, !prof !115, !llvm.loop !116

.89.endif.i126:                                   ; preds = %.89.endif.i126.preheader, %.89.endif.i126
  %lsr.iv.i127 = phi i64 [ %lsr.iv.next.i154.3, %.89.endif.i126 ], [ %lsr.iv.i127.ph, %.89.endif.i126.preheader ]
  %.77.013.i128 = phi ptr [ %.114.7.i153.3, %.89.endif.i126 ], [ %.77.013.i128.ph, %.89.endif.i126.preheader ]
  %.72.012.i129 = phi double [ %.108.7.i152.3, %.89.endif.i126 ], [ %.72.012.i129.ph, %.89.endif.i126.preheader ]
  %.106.i130 = load double, ptr %.77.013.i128, align 8, !noalias !177
  %.108.i131 = fadd double %.72.012.i129, %.106.i130
  %.114.i132 = getelementptr i8, ptr %.77.013.i128, i64 8
  %.106.1.i133 = load double, ptr %.114.i132, align 8, !noalias !177
  %.108.1.i134 = fadd double %.108.i131, %.106.1.i133
  %.114.1.i135 = getelementptr i8, ptr %.77.013.i128, i64 16
  %.106.2.i136 = load double, ptr %.114.1.i135, align 8, !noalias !177
  %.108.2.i137 = fadd double %.108.1.i134, %.106.2.i136
  %.114.2.i138 = getelementptr i8, ptr %.77.013.i128, i64 24
  %.106.3.i139 = load double, ptr %.114.2.i138, align 8, !noalias !177
  %.108.3.i140 = fadd double %.108.2.i137, %.106.3.i139
  %.114.3.i141 = getelementptr i8, ptr %.77.013.i128, i64 32
  %.106.4.i142 = load double, ptr %.114.3.i141, align 8, !noalias !177
  %.108.4.i143 = fadd double %.108.3.i140, %.106.4.i142
  %.114.4.i144 = getelementptr i8, ptr %.77.013.i128, i64 40
  %.106.5.i145 = load double, ptr %.114.4.i144, align 8, !noalias !177
  %.108.5.i146 = fadd double %.108.4.i143, %.106.5.i145
  %.114.5.i147 = getelementptr i8, ptr %.77.013.i128, i64 48
  %.106.6.i148 = load double, ptr %.114.5.i147, align 8, !noalias !177
  %.108.6.i149 = fadd double %.108.5.i146, %.106.6.i148
  %.114.6.i150 = getelementptr i8, ptr %.77.013.i128, i64 56
  %.106.7.i151 = load double, ptr %.114.6.i150, align 8, !noalias !177
  %.108.7.i152 = fadd double %.108.6.i149, %.106.7.i151
  %.114.7.i153 = getelementptr i8, ptr %.77.013.i128, i64 64
  %.106.i130.1 = load double, ptr %.114.7.i153, align 8, !noalias !177
  %.108.i131.1 = fadd double %.108.7.i152, %.106.i130.1
  %.114.i132.1 = getelementptr i8, ptr %.77.013.i128, i64 72
  %.106.1.i133.1 = load double, ptr %.114.i132.1, align 8, !noalias !177
  %.108.1.i134.1 = fadd double %.108.i131.1, %.106.1.i133.1
  %.114.1.i135.1 = getelementptr i8, ptr %.77.013.i128, i64 80
  %.106.2.i136.1 = load double, ptr %.114.1.i135.1, align 8, !noalias !177
  %.108.2.i137.1 = fadd double %.108.1.i134.1, %.106.2.i136.1
  %.114.2.i138.1 = getelementptr i8, ptr %.77.013.i128, i64 88
  %.106.3.i139.1 = load double, ptr %.114.2.i138.1, align 8, !noalias !177
  %.108.3.i140.1 = fadd double %.108.2.i137.1, %.106.3.i139.1
  %.114.3.i141.1 = getelementptr i8, ptr %.77.013.i128, i64 96
  %.106.4.i142.1 = load double, ptr %.114.3.i141.1, align 8, !noalias !177
  %.108.4.i143.1 = fadd double %.108.3.i140.1, %.106.4.i142.1
  %.114.4.i144.1 = getelementptr i8, ptr %.77.013.i128, i64 104
  %.106.5.i145.1 = load double, ptr %.114.4.i144.1, align 8, !noalias !177
  %.108.5.i146.1 = fadd double %.108.4.i143.1, %.106.5.i145.1
  %.114.5.i147.1 = getelementptr i8, ptr %.77.013.i128, i64 112
  %.106.6.i148.1 = load double, ptr %.114.5.i147.1, align 8, !noalias !177
  %.108.6.i149.1 = fadd double %.108.5.i146.1, %.106.6.i148.1
  %.114.6.i150.1 = getelementptr i8, ptr %.77.013.i128, i64 120
  %.106.7.i151.1 = load double, ptr %.114.6.i150.1, align 8, !noalias !177
  %.108.7.i152.1 = fadd double %.108.6.i149.1, %.106.7.i151.1
  %.114.7.i153.1 = getelementptr i8, ptr %.77.013.i128, i64 128
  %.106.i130.2 = load double, ptr %.114.7.i153.1, align 8, !noalias !177
  %.108.i131.2 = fadd double %.108.7.i152.1, %.106.i130.2
  %.114.i132.2 = getelementptr i8, ptr %.77.013.i128, i64 136
  %.106.1.i133.2 = load double, ptr %.114.i132.2, align 8, !noalias !177
  %.108.1.i134.2 = fadd double %.108.i131.2, %.106.1.i133.2
  %.114.1.i135.2 = getelementptr i8, ptr %.77.013.i128, i64 144
  %.106.2.i136.2 = load double, ptr %.114.1.i135.2, align 8, !noalias !177
  %.108.2.i137.2 = fadd double %.108.1.i134.2, %.106.2.i136.2
  %.114.2.i138.2 = getelementptr i8, ptr %.77.013.i128, i64 152
  %.106.3.i139.2 = load double, ptr %.114.2.i138.2, align 8, !noalias !177
  %.108.3.i140.2 = fadd double %.108.2.i137.2, %.106.3.i139.2
  %.114.3.i141.2 = getelementptr i8, ptr %.77.013.i128, i64 160
  %.106.4.i142.2 = load double, ptr %.114.3.i141.2, align 8, !noalias !177
  %.108.4.i143.2 = fadd double %.108.3.i140.2, %.106.4.i142.2
  %.114.4.i144.2 = getelementptr i8, ptr %.77.013.i128, i64 168
  %.106.5.i145.2 = load double, ptr %.114.4.i144.2, align 8, !noalias !177
  %.108.5.i146.2 = fadd double %.108.4.i143.2, %.106.5.i145.2
  %.114.5.i147.2 = getelementptr i8, ptr %.77.013.i128, i64 176
  %.106.6.i148.2 = load double, ptr %.114.5.i147.2, align 8, !noalias !177
  %.108.6.i149.2 = fadd double %.108.5.i146.2, %.106.6.i148.2
  %.114.6.i150.2 = getelementptr i8, ptr %.77.013.i128, i64 184
  %.106.7.i151.2 = load double, ptr %.114.6.i150.2, align 8, !noalias !177
  %.108.7.i152.2 = fadd double %.108.6.i149.2, %.106.7.i151.2
  %.114.7.i153.2 = getelementptr i8, ptr %.77.013.i128, i64 192
  %.106.i130.3 = load double, ptr %.114.7.i153.2, align 8, !noalias !177
  %.108.i131.3 = fadd double %.108.7.i152.2, %.106.i130.3
  %.114.i132.3 = getelementptr i8, ptr %.77.013.i128, i64 200
  %.106.1.i133.3 = load double, ptr %.114.i132.3, align 8, !noalias !177
  %.108.1.i134.3 = fadd double %.108.i131.3, %.106.1.i133.3
  %.114.1.i135.3 = getelementptr i8, ptr %.77.013.i128, i64 208
  %.106.2.i136.3 = load double, ptr %.114.1.i135.3, align 8, !noalias !177
  %.108.2.i137.3 = fadd double %.108.1.i134.3, %.106.2.i136.3
  %.114.2.i138.3 = getelementptr i8, ptr %.77.013.i128, i64 216
  %.106.3.i139.3 = load double, ptr %.114.2.i138.3, align 8, !noalias !177
  %.108.3.i140.3 = fadd double %.108.2.i137.3, %.106.3.i139.3
  %.114.3.i141.3 = getelementptr i8, ptr %.77.013.i128, i64 224
  %.106.4.i142.3 = load double, ptr %.114.3.i141.3, align 8, !noalias !177
  %.108.4.i143.3 = fadd double %.108.3.i140.3, %.106.4.i142.3
  %.114.4.i144.3 = getelementptr i8, ptr %.77.013.i128, i64 232
  %.106.5.i145.3 = load double, ptr %.114.4.i144.3, align 8, !noalias !177
  %.108.5.i146.3 = fadd double %.108.4.i143.3, %.106.5.i145.3
  %.114.5.i147.3 = getelementptr i8, ptr %.77.013.i128, i64 240
  %.106.6.i148.3 = load double, ptr %.114.5.i147.3, align 8, !noalias !177
  %.108.6.i149.3 = fadd double %.108.5.i146.3, %.106.6.i148.3
  %.114.6.i150.3 = getelementptr i8, ptr %.77.013.i128, i64 248
  %.106.7.i151.3 = load double, ptr %.114.6.i150.3, align 8, !noalias !177
  %.108.7.i152.3 = fadd double %.108.6.i149.3, %.106.7.i151.3
  %.114.7.i153.3 = getelementptr i8, ptr %.77.013.i128, i64 256
  %lsr.iv.next.i154.3 = add nsw i64 %lsr.iv.i127, -32
  %niter.ncmp.7.i155.3 = icmp eq i64 %lsr.iv.next.i154.3, 0
  br i1 %niter.ncmp.7.i155.3, label %common.ret.loopexit.unr-lcssa.i156, label %.89.endif.i126, !prof !118, !llvm.loop !181

.89.endif.preheader.i122.thread16:                ; preds = %B642.endif.endif.endif.endif.endif.endif.endif.endif
  %.1164 = load double, ptr %.6.i.i81, align 8
  %.1173 = load double, ptr %.6.i.i60, align 8
  %.10.i116 = fdiv double %.1164, %.959
  %.11.i117 = fsub double 1.000000e+00, %.10.i116
  %.12.i118 = fmul double %.1173, %.11.i117
  store double %.12.i118, ptr %.6.i, align 8
  br label %.89.endif.epil.preheader.i158

B128.i187:                                        ; preds = %.89.endif.epil.i161, %common.ret.loopexit.unr-lcssa.i156, %B642.endif.endif.endif.endif.endif.endif.endif.endif
  %.72.0.lcssa.i121 = phi double [ 0.000000e+00, %B642.endif.endif.endif.endif.endif.endif.endif.endif ], [ %.108.7.i152.lcssa, %common.ret.loopexit.unr-lcssa.i156 ], [ %.108.epil.i166, %.89.endif.epil.i161 ]
  tail call void @NRT_decref(ptr nonnull %.7.i.i.i77)
  tail call void @NRT_decref(ptr nonnull %.7.i.i)
  %.1244 = fadd double %arg.form.0, %.72.0.lcssa.i121
  %.1245 = fmul double %.1244, 4.000000e+00
  %.1249 = fdiv double %.1245, %.72.0.lcssa.i
  %.12.i170 = fcmp olt double %.1249, 1.000000e+00
  %.13.i = select i1 %.12.i170, double %.1249, double 1.000000e+00
  %.1278 = fsub double 1.000000e+00, %.13.i
  %.7.i.i191 = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.29.i, i32 32), !noalias !182
  %.8.i.i192 = icmp eq ptr %.7.i.i191, null
  br i1 %.8.i.i192, label %for.end.endif.endif.endif.endif.endif.endif.if.if, label %for.end.endif.endif.endif.endif.endif.endif.endif, !prof !11

for.end.endif.endif.endif.endif.endif.endif.endif: ; preds = %B128.i187
  %.5.i197 = getelementptr i8, ptr %.7.i.i191, i64 24
  %.6.i198 = load ptr, ptr %.5.i197, align 8
  switch i64 %.99.fca.5.0.load.fr349, label %iter.check [
    i64 0, label %for.end.3.endif.critedge
    i64 1, label %for.body.2.lr.ph.split
  ]

iter.check:                                       ; preds = %for.end.endif.endif.endif.endif.endif.endif.endif
  %44 = ptrtoint ptr %.6.i.i39 to i64
  %.6.i198446 = ptrtoint ptr %.6.i198 to i64
  %min.iters.check450 = icmp ult i64 %.99.fca.5.0.load.fr349, 4
  %45 = sub i64 %.6.i198446, %44
  %diff.check448 = icmp ult i64 %45, 256
  %or.cond = select i1 %min.iters.check450, i1 true, i1 %diff.check448
  br i1 %or.cond, label %for.body.1.endif.endif.us.preheader, label %vector.main.loop.iter.check

vector.main.loop.iter.check:                      ; preds = %iter.check
  %min.iters.check452 = icmp ult i64 %.99.fca.5.0.load.fr349, 32
  br i1 %min.iters.check452, label %vec.epilog.ph, label %vector.ph453

vector.ph453:                                     ; preds = %vector.main.loop.iter.check
  %const_mat = add i64 %const, -24
  %n.vec455 = and i64 %.99.fca.5.0.load.fr349, %const_mat
  %broadcast.splatinsert456 = insertelement <8 x double> poison, double %.1278, i64 0
  %broadcast.splat457 = shufflevector <8 x double> %broadcast.splatinsert456, <8 x double> poison, <8 x i32> zeroinitializer
  br label %vector.body458

vector.body458:                                   ; preds = %vector.body458, %vector.ph453
  %index459 = phi i64 [ 0, %vector.ph453 ], [ %index.next464, %vector.body458 ]
  %sunkaddr323 = mul i64 %index459, 8
  %sunkaddr324 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr323
  %wide.load460 = load <8 x double>, ptr %sunkaddr324, align 8
  %sunkaddr325 = mul i64 %index459, 8
  %sunkaddr326 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr325
  %sunkaddr327 = getelementptr i8, ptr %sunkaddr326, i64 64
  %wide.load461 = load <8 x double>, ptr %sunkaddr327, align 8
  %sunkaddr328 = mul i64 %index459, 8
  %sunkaddr329 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr328
  %sunkaddr330 = getelementptr i8, ptr %sunkaddr329, i64 128
  %wide.load462 = load <8 x double>, ptr %sunkaddr330, align 8
  %sunkaddr331 = mul i64 %index459, 8
  %sunkaddr332 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr331
  %sunkaddr333 = getelementptr i8, ptr %sunkaddr332, i64 192
  %wide.load463 = load <8 x double>, ptr %sunkaddr333, align 8
  %46 = fmul <8 x double> %broadcast.splat457, %wide.load460
  %47 = fmul <8 x double> %broadcast.splat457, %wide.load461
  %48 = fmul <8 x double> %broadcast.splat457, %wide.load462
  %49 = fmul <8 x double> %broadcast.splat457, %wide.load463
  %sunkaddr334 = mul i64 %index459, 8
  %sunkaddr335 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr334
  store <8 x double> %46, ptr %sunkaddr335, align 8
  %sunkaddr336 = mul i64 %index459, 8
  %sunkaddr337 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr336
  %sunkaddr338 = getelementptr i8, ptr %sunkaddr337, i64 64
  store <8 x double> %47, ptr %sunkaddr338, align 8
  %sunkaddr339 = mul i64 %index459, 8
  %sunkaddr340 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr339
  %sunkaddr341 = getelementptr i8, ptr %sunkaddr340, i64 128
  store <8 x double> %48, ptr %sunkaddr341, align 8
  %sunkaddr342 = mul i64 %index459, 8
  %sunkaddr343 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr342
  %sunkaddr344 = getelementptr i8, ptr %sunkaddr343, i64 192
  store <8 x double> %49, ptr %sunkaddr344, align 8
  %index.next464 = add nuw i64 %index459, 32
  %50 = icmp eq i64 %n.vec455, %index.next464
  br i1 %50, label %middle.block465, label %vector.body458, !llvm.loop !189

middle.block465:                                  ; preds = %vector.body458
  %cmp.n466 = icmp eq i64 %.99.fca.5.0.load.fr349, %n.vec455
  br i1 %cmp.n466, label %vector.memcheck476, label %vec.epilog.iter.check

vec.epilog.iter.check:                            ; preds = %middle.block465
  %n.mod.vf454 = and i64 %.99.fca.5.0.load.fr349, 28
  %min.epilog.iters.check = icmp eq i64 %n.mod.vf454, 0
  br i1 %min.epilog.iters.check, label %for.body.1.endif.endif.us.preheader, label %vec.epilog.ph, !prof !91

vec.epilog.ph:                                    ; preds = %vec.epilog.iter.check, %vector.main.loop.iter.check
  %vec.epilog.resume.val = phi i64 [ %n.vec455, %vec.epilog.iter.check ], [ 0, %vector.main.loop.iter.check ]
  %const_mat249 = add i64 %const, 4
  %n.vec468 = and i64 %.99.fca.5.0.load.fr349, %const_mat249
  %broadcast.splatinsert469 = insertelement <4 x double> poison, double %.1278, i64 0
  %broadcast.splat470 = shufflevector <4 x double> %broadcast.splatinsert469, <4 x double> poison, <4 x i32> zeroinitializer
  br label %vec.epilog.vector.body

vec.epilog.vector.body:                           ; preds = %vec.epilog.vector.body, %vec.epilog.ph
  %index471 = phi i64 [ %vec.epilog.resume.val, %vec.epilog.ph ], [ %index.next473, %vec.epilog.vector.body ]
  %51 = shl i64 %index471, 3
  %scevgep167 = getelementptr i8, ptr %.6.i.i39, i64 %51
  %wide.load472 = load <4 x double>, ptr %scevgep167, align 8
  %52 = fmul <4 x double> %broadcast.splat470, %wide.load472
  %53 = shl i64 %index471, 3
  %scevgep166 = getelementptr i8, ptr %.6.i198, i64 %53
  store <4 x double> %52, ptr %scevgep166, align 8
  %index.next473 = add nuw i64 %index471, 4
  %54 = icmp eq i64 %n.vec468, %index.next473
  br i1 %54, label %vec.epilog.middle.block, label %vec.epilog.vector.body, !llvm.loop !190

vec.epilog.middle.block:                          ; preds = %vec.epilog.vector.body
  %cmp.n474 = icmp eq i64 %.99.fca.5.0.load.fr349, %n.vec468
  br i1 %cmp.n474, label %vector.memcheck476, label %for.body.1.endif.endif.us.preheader

for.body.1.endif.endif.us.preheader:              ; preds = %vec.epilog.middle.block, %vec.epilog.iter.check, %iter.check
  %loop.index.1675.us.ph = phi i64 [ 0, %iter.check ], [ %n.vec455, %vec.epilog.iter.check ], [ %n.vec468, %vec.epilog.middle.block ]
  %55 = sub nsw i64 %.99.fca.5.0.load.fr349, %loop.index.1675.us.ph
  %xtraiter559 = and i64 %55, 7
  %lcmp.mod560.not = icmp eq i64 %xtraiter559, 0
  br i1 %lcmp.mod560.not, label %for.body.1.endif.endif.us.prol.loopexit, label %for.body.1.endif.endif.us.prol.preheader

for.body.1.endif.endif.us.prol.preheader:         ; preds = %for.body.1.endif.endif.us.preheader
  br label %for.body.1.endif.endif.us.prol

for.body.1.endif.endif.us.prol:                   ; preds = %for.body.1.endif.endif.us.prol.preheader, %for.body.1.endif.endif.us.prol
  %lsr.iv164 = phi i64 [ %xtraiter559, %for.body.1.endif.endif.us.prol.preheader ], [ %lsr.iv.next165, %for.body.1.endif.endif.us.prol ]
  %loop.index.1675.us.prol = phi i64 [ %.1449.us.prol, %for.body.1.endif.endif.us.prol ], [ %loop.index.1675.us.ph, %for.body.1.endif.endif.us.prol.preheader ]
  %56 = shl nuw i64 %loop.index.1675.us.prol, 3
  %scevgep163 = getelementptr i8, ptr %.6.i.i39, i64 %56
  %.1420.us.prol = load double, ptr %scevgep163, align 8
  %.6.i199.prol = fmul double %.1278, %.1420.us.prol
  %57 = shl nuw i64 %loop.index.1675.us.prol, 3
  %scevgep162 = getelementptr i8, ptr %.6.i198, i64 %57
  store double %.6.i199.prol, ptr %scevgep162, align 8
  %.1449.us.prol = add nuw nsw i64 %loop.index.1675.us.prol, 1
  %lsr.iv.next165 = add nsw i64 %lsr.iv164, -1
  %prol.iter561.cmp.not = icmp eq i64 %lsr.iv.next165, 0
  br i1 %prol.iter561.cmp.not, label %for.body.1.endif.endif.us.prol.loopexit, label %for.body.1.endif.endif.us.prol, !llvm.loop !191

for.body.1.endif.endif.us.prol.loopexit:          ; preds = %for.body.1.endif.endif.us.prol, %for.body.1.endif.endif.us.preheader
  %loop.index.1675.us.unr = phi i64 [ %loop.index.1675.us.ph, %for.body.1.endif.endif.us.preheader ], [ %.1449.us.prol, %for.body.1.endif.endif.us.prol ]
  %58 = sub nsw i64 %loop.index.1675.us.ph, %.99.fca.5.0.load.fr349
  %59 = icmp ugt i64 %58, -8
  br i1 %59, label %iter.check481, label %for.body.1.endif.endif.us.preheader69

for.body.1.endif.endif.us.preheader69:            ; preds = %for.body.1.endif.endif.us.prol.loopexit
  br label %for.body.1.endif.endif.us

for.body.1.endif.endif.us:                        ; preds = %for.body.1.endif.endif.us.preheader69, %for.body.1.endif.endif.us
  %loop.index.1675.us = phi i64 [ %.1449.us.7, %for.body.1.endif.endif.us ], [ %loop.index.1675.us.unr, %for.body.1.endif.endif.us.preheader69 ]
  %sunkaddr345 = mul i64 %loop.index.1675.us, 8
  %sunkaddr346 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr345
  %.1420.us = load double, ptr %sunkaddr346, align 8
  %.6.i199 = fmul double %.1278, %.1420.us
  %sunkaddr347 = mul i64 %loop.index.1675.us, 8
  %sunkaddr348 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr347
  store double %.6.i199, ptr %sunkaddr348, align 8
  %sunkaddr349 = mul i64 %loop.index.1675.us, 8
  %sunkaddr350 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr349
  %sunkaddr351 = getelementptr i8, ptr %sunkaddr350, i64 8
  %.1420.us.1 = load double, ptr %sunkaddr351, align 8
  %.6.i199.1 = fmul double %.1278, %.1420.us.1
  %sunkaddr352 = mul i64 %loop.index.1675.us, 8
  %sunkaddr353 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr352
  %sunkaddr354 = getelementptr i8, ptr %sunkaddr353, i64 8
  store double %.6.i199.1, ptr %sunkaddr354, align 8
  %sunkaddr355 = mul i64 %loop.index.1675.us, 8
  %sunkaddr356 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr355
  %sunkaddr357 = getelementptr i8, ptr %sunkaddr356, i64 16
  %.1420.us.2 = load double, ptr %sunkaddr357, align 8
  %.6.i199.2 = fmul double %.1278, %.1420.us.2
  %sunkaddr358 = mul i64 %loop.index.1675.us, 8
  %sunkaddr359 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr358
  %sunkaddr360 = getelementptr i8, ptr %sunkaddr359, i64 16
  store double %.6.i199.2, ptr %sunkaddr360, align 8
  %sunkaddr361 = mul i64 %loop.index.1675.us, 8
  %sunkaddr362 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr361
  %sunkaddr363 = getelementptr i8, ptr %sunkaddr362, i64 24
  %.1420.us.3 = load double, ptr %sunkaddr363, align 8
  %.6.i199.3 = fmul double %.1278, %.1420.us.3
  %sunkaddr364 = mul i64 %loop.index.1675.us, 8
  %sunkaddr365 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr364
  %sunkaddr366 = getelementptr i8, ptr %sunkaddr365, i64 24
  store double %.6.i199.3, ptr %sunkaddr366, align 8
  %sunkaddr367 = mul i64 %loop.index.1675.us, 8
  %sunkaddr368 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr367
  %sunkaddr369 = getelementptr i8, ptr %sunkaddr368, i64 32
  %.1420.us.4 = load double, ptr %sunkaddr369, align 8
  %.6.i199.4 = fmul double %.1278, %.1420.us.4
  %sunkaddr370 = mul i64 %loop.index.1675.us, 8
  %sunkaddr371 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr370
  %sunkaddr372 = getelementptr i8, ptr %sunkaddr371, i64 32
  store double %.6.i199.4, ptr %sunkaddr372, align 8
  %sunkaddr373 = mul i64 %loop.index.1675.us, 8
  %sunkaddr374 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr373
  %sunkaddr375 = getelementptr i8, ptr %sunkaddr374, i64 40
  %.1420.us.5 = load double, ptr %sunkaddr375, align 8
  %.6.i199.5 = fmul double %.1278, %.1420.us.5
  %sunkaddr376 = mul i64 %loop.index.1675.us, 8
  %sunkaddr377 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr376
  %sunkaddr378 = getelementptr i8, ptr %sunkaddr377, i64 40
  store double %.6.i199.5, ptr %sunkaddr378, align 8
  %sunkaddr379 = mul i64 %loop.index.1675.us, 8
  %sunkaddr380 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr379
  %sunkaddr381 = getelementptr i8, ptr %sunkaddr380, i64 48
  %.1420.us.6 = load double, ptr %sunkaddr381, align 8
  %.6.i199.6 = fmul double %.1278, %.1420.us.6
  %sunkaddr382 = mul i64 %loop.index.1675.us, 8
  %sunkaddr383 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr382
  %sunkaddr384 = getelementptr i8, ptr %sunkaddr383, i64 48
  store double %.6.i199.6, ptr %sunkaddr384, align 8
  %sunkaddr385 = mul i64 %loop.index.1675.us, 8
  %sunkaddr386 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr385
  %sunkaddr387 = getelementptr i8, ptr %sunkaddr386, i64 56
  %.1420.us.7 = load double, ptr %sunkaddr387, align 8
  %.6.i199.7 = fmul double %.1278, %.1420.us.7
  %sunkaddr388 = mul i64 %loop.index.1675.us, 8
  %sunkaddr389 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr388
  %sunkaddr390 = getelementptr i8, ptr %sunkaddr389, i64 56
  store double %.6.i199.7, ptr %sunkaddr390, align 8
  %.1449.us.7 = add nuw nsw i64 %loop.index.1675.us, 8
  %exitcond712.not.7 = icmp eq i64 %.99.fca.5.0.load.fr349, %.1449.us.7
  br i1 %exitcond712.not.7, label %vector.memcheck476, label %for.body.1.endif.endif.us, !llvm.loop !192

for.end.endif.endif.endif.endif.endif.endif.if.if: ; preds = %B128.i187
  store ptr @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.22, ptr %excinfo, align 8
  br label %common.ret

iter.check481:                                    ; preds = %for.body.1.endif.endif.us.prol.loopexit
  %60 = icmp ult i64 %.99.fca.5.0.load.fr349, 4
  br i1 %60, label %for.body.2.us.us.preheader, label %vector.memcheck476

vector.memcheck476:                               ; preds = %for.body.1.endif.endif.us, %middle.block465, %vec.epilog.middle.block, %iter.check481
  %scevgep = getelementptr i8, ptr %.6.i.i18, i64 %.29.i
  %scevgep477 = getelementptr i8, ptr %.6.i198, i64 %.29.i
  %bound0 = icmp ult ptr %.6.i.i18, %scevgep477
  %bound1 = icmp ult ptr %.6.i198, %scevgep
  %found.conflict = and i1 %bound1, %bound0
  br i1 %found.conflict, label %for.body.2.us.us.preheader, label %vector.main.loop.iter.check483

vector.main.loop.iter.check483:                   ; preds = %vector.memcheck476
  %min.iters.check482 = icmp ult i64 %.99.fca.5.0.load.fr349, 32
  br i1 %min.iters.check482, label %vec.epilog.ph504, label %vector.ph484

vector.ph484:                                     ; preds = %vector.main.loop.iter.check483
  %const_mat247 = add i64 %const, -24
  %n.vec486 = and i64 %.99.fca.5.0.load.fr349, %const_mat247
  br label %vector.body487

vector.body487:                                   ; preds = %vector.body487, %vector.ph484
  %index488 = phi i64 [ 0, %vector.ph484 ], [ %index.next497, %vector.body487 ]
  %sunkaddr399 = mul i64 %index488, 8
  %sunkaddr400 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr399
  %sunkaddr401 = getelementptr i8, ptr %sunkaddr400, i64 192
  %sunkaddr391 = mul i64 %index488, 8
  %sunkaddr392 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr391
  %wide.load489 = load <8 x double>, ptr %sunkaddr392, align 8, !alias.scope !193, !noalias !196
  %sunkaddr393 = mul i64 %index488, 8
  %sunkaddr394 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr393
  %sunkaddr395 = getelementptr i8, ptr %sunkaddr394, i64 64
  %wide.load490 = load <8 x double>, ptr %sunkaddr395, align 8, !alias.scope !193, !noalias !196
  %sunkaddr396 = mul i64 %index488, 8
  %sunkaddr397 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr396
  %sunkaddr398 = getelementptr i8, ptr %sunkaddr397, i64 128
  %wide.load491 = load <8 x double>, ptr %sunkaddr398, align 8, !alias.scope !193, !noalias !196
  %wide.load492 = load <8 x double>, ptr %sunkaddr401, align 8, !alias.scope !193, !noalias !196
  %sunkaddr402 = mul i64 %index488, 8
  %sunkaddr403 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr402
  %wide.load493 = load <8 x double>, ptr %sunkaddr403, align 8, !alias.scope !196
  %sunkaddr404 = mul i64 %index488, 8
  %sunkaddr405 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr404
  %sunkaddr406 = getelementptr i8, ptr %sunkaddr405, i64 64
  %wide.load494 = load <8 x double>, ptr %sunkaddr406, align 8, !alias.scope !196
  %sunkaddr407 = mul i64 %index488, 8
  %sunkaddr408 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr407
  %sunkaddr409 = getelementptr i8, ptr %sunkaddr408, i64 128
  %wide.load495 = load <8 x double>, ptr %sunkaddr409, align 8, !alias.scope !196
  %sunkaddr410 = mul i64 %index488, 8
  %sunkaddr411 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr410
  %sunkaddr412 = getelementptr i8, ptr %sunkaddr411, i64 192
  %wide.load496 = load <8 x double>, ptr %sunkaddr412, align 8, !alias.scope !196
  %61 = fadd <8 x double> %wide.load489, %wide.load493
  %62 = fadd <8 x double> %wide.load490, %wide.load494
  %63 = fadd <8 x double> %wide.load491, %wide.load495
  %64 = fadd <8 x double> %wide.load492, %wide.load496
  store <8 x double> %61, ptr %sunkaddr392, align 8, !alias.scope !193, !noalias !196
  store <8 x double> %62, ptr %sunkaddr395, align 8, !alias.scope !193, !noalias !196
  store <8 x double> %63, ptr %sunkaddr398, align 8, !alias.scope !193, !noalias !196
  store <8 x double> %64, ptr %sunkaddr401, align 8, !alias.scope !193, !noalias !196
  %index.next497 = add nuw i64 %index488, 32
  %65 = icmp eq i64 %n.vec486, %index.next497
  br i1 %65, label %middle.block498, label %vector.body487, !llvm.loop !198

middle.block498:                                  ; preds = %vector.body487
  %cmp.n499 = icmp eq i64 %.99.fca.5.0.load.fr349, %n.vec486
  br i1 %cmp.n499, label %for.body.3.lr.ph, label %vec.epilog.iter.check502

vec.epilog.iter.check502:                         ; preds = %middle.block498
  %n.mod.vf485 = and i64 %.99.fca.5.0.load.fr349, 28
  %min.epilog.iters.check503 = icmp eq i64 %n.mod.vf485, 0
  br i1 %min.epilog.iters.check503, label %for.body.2.us.us.preheader, label %vec.epilog.ph504, !prof !91

vec.epilog.ph504:                                 ; preds = %vec.epilog.iter.check502, %vector.main.loop.iter.check483
  %vec.epilog.resume.val500 = phi i64 [ %n.vec486, %vec.epilog.iter.check502 ], [ 0, %vector.main.loop.iter.check483 ]
  %const_mat250 = add i64 %const, 4
  %n.vec506 = and i64 %.99.fca.5.0.load.fr349, %const_mat250
  br label %vec.epilog.vector.body507

vec.epilog.vector.body507:                        ; preds = %vec.epilog.vector.body507, %vec.epilog.ph504
  %index508 = phi i64 [ %vec.epilog.resume.val500, %vec.epilog.ph504 ], [ %index.next511, %vec.epilog.vector.body507 ]
  %66 = shl i64 %index508, 3
  %scevgep119 = getelementptr i8, ptr %.6.i.i18, i64 %66
  %wide.load509 = load <4 x double>, ptr %scevgep119, align 8, !alias.scope !193, !noalias !196
  %67 = shl i64 %index508, 3
  %scevgep118 = getelementptr i8, ptr %.6.i198, i64 %67
  %wide.load510 = load <4 x double>, ptr %scevgep118, align 8, !alias.scope !196
  %68 = fadd <4 x double> %wide.load509, %wide.load510
  store <4 x double> %68, ptr %scevgep119, align 8, !alias.scope !193, !noalias !196
  %index.next511 = add nuw i64 %index508, 4
  %69 = icmp eq i64 %n.vec506, %index.next511
  br i1 %69, label %vec.epilog.middle.block512, label %vec.epilog.vector.body507, !llvm.loop !199

vec.epilog.middle.block512:                       ; preds = %vec.epilog.vector.body507
  %cmp.n513 = icmp eq i64 %.99.fca.5.0.load.fr349, %n.vec506
  br i1 %cmp.n513, label %for.body.3.lr.ph, label %for.body.2.us.us.preheader

for.body.2.us.us.preheader:                       ; preds = %vec.epilog.middle.block512, %vec.epilog.iter.check502, %vector.memcheck476, %iter.check481
  %loop.index.2680.us.us.ph = phi i64 [ 0, %iter.check481 ], [ 0, %vector.memcheck476 ], [ %n.vec486, %vec.epilog.iter.check502 ], [ %n.vec506, %vec.epilog.middle.block512 ]
  %70 = sub nsw i64 %.99.fca.5.0.load.fr349, %loop.index.2680.us.us.ph
  %xtraiter562 = and i64 %70, 7
  %lcmp.mod563.not = icmp eq i64 %xtraiter562, 0
  br i1 %lcmp.mod563.not, label %for.body.2.us.us.prol.loopexit, label %for.body.2.us.us.prol.preheader

for.body.2.us.us.prol.preheader:                  ; preds = %for.body.2.us.us.preheader
  br label %for.body.2.us.us.prol

for.body.2.us.us.prol:                            ; preds = %for.body.2.us.us.prol.preheader, %for.body.2.us.us.prol
  %lsr.iv116 = phi i64 [ %xtraiter562, %for.body.2.us.us.prol.preheader ], [ %lsr.iv.next117, %for.body.2.us.us.prol ]
  %loop.index.2680.us.us.prol = phi i64 [ %.1529.us.us.prol, %for.body.2.us.us.prol ], [ %loop.index.2680.us.us.ph, %for.body.2.us.us.prol.preheader ]
  %71 = shl nuw i64 %loop.index.2680.us.us.prol, 3
  %scevgep115 = getelementptr i8, ptr %.6.i.i18, i64 %71
  %.1514.us.us.prol = load double, ptr %scevgep115, align 8
  %72 = shl nuw i64 %loop.index.2680.us.us.prol, 3
  %scevgep114 = getelementptr i8, ptr %.6.i198, i64 %72
  %.1523.us.us.prol = load double, ptr %scevgep114, align 8
  %.1524.us.us.prol = fadd double %.1514.us.us.prol, %.1523.us.us.prol
  store double %.1524.us.us.prol, ptr %scevgep115, align 8
  %.1529.us.us.prol = add nuw nsw i64 %loop.index.2680.us.us.prol, 1
  %lsr.iv.next117 = add nsw i64 %lsr.iv116, -1
  %prol.iter564.cmp.not = icmp eq i64 %lsr.iv.next117, 0
  br i1 %prol.iter564.cmp.not, label %for.body.2.us.us.prol.loopexit, label %for.body.2.us.us.prol, !llvm.loop !200

for.body.2.us.us.prol.loopexit:                   ; preds = %for.body.2.us.us.prol, %for.body.2.us.us.preheader
  %loop.index.2680.us.us.unr = phi i64 [ %loop.index.2680.us.us.ph, %for.body.2.us.us.preheader ], [ %.1529.us.us.prol, %for.body.2.us.us.prol ]
  %73 = sub nsw i64 %loop.index.2680.us.us.ph, %.99.fca.5.0.load.fr349
  %74 = icmp ugt i64 %73, -8
  br i1 %74, label %for.body.3.lr.ph, label %for.body.2.us.us.preheader68

for.body.2.us.us.preheader68:                     ; preds = %for.body.2.us.us.prol.loopexit
  br label %for.body.2.us.us

for.body.2.us.us:                                 ; preds = %for.body.2.us.us.preheader68, %for.body.2.us.us
  %loop.index.2680.us.us = phi i64 [ %.1529.us.us.7, %for.body.2.us.us ], [ %loop.index.2680.us.us.unr, %for.body.2.us.us.preheader68 ]
  %sunkaddr413 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr414 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr413
  %.1514.us.us = load double, ptr %sunkaddr414, align 8
  %sunkaddr415 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr416 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr415
  %.1523.us.us = load double, ptr %sunkaddr416, align 8
  %.1524.us.us = fadd double %.1514.us.us, %.1523.us.us
  store double %.1524.us.us, ptr %sunkaddr414, align 8
  %sunkaddr417 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr418 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr417
  %sunkaddr419 = getelementptr i8, ptr %sunkaddr418, i64 8
  %.1514.us.us.1 = load double, ptr %sunkaddr419, align 8
  %sunkaddr420 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr421 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr420
  %sunkaddr422 = getelementptr i8, ptr %sunkaddr421, i64 8
  %.1523.us.us.1 = load double, ptr %sunkaddr422, align 8
  %.1524.us.us.1 = fadd double %.1514.us.us.1, %.1523.us.us.1
  store double %.1524.us.us.1, ptr %sunkaddr419, align 8
  %sunkaddr423 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr424 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr423
  %sunkaddr425 = getelementptr i8, ptr %sunkaddr424, i64 16
  %.1514.us.us.2 = load double, ptr %sunkaddr425, align 8
  %sunkaddr426 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr427 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr426
  %sunkaddr428 = getelementptr i8, ptr %sunkaddr427, i64 16
  %.1523.us.us.2 = load double, ptr %sunkaddr428, align 8
  %.1524.us.us.2 = fadd double %.1514.us.us.2, %.1523.us.us.2
  store double %.1524.us.us.2, ptr %sunkaddr425, align 8
  %sunkaddr429 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr430 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr429
  %sunkaddr431 = getelementptr i8, ptr %sunkaddr430, i64 24
  %.1514.us.us.3 = load double, ptr %sunkaddr431, align 8
  %sunkaddr432 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr433 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr432
  %sunkaddr434 = getelementptr i8, ptr %sunkaddr433, i64 24
  %.1523.us.us.3 = load double, ptr %sunkaddr434, align 8
  %.1524.us.us.3 = fadd double %.1514.us.us.3, %.1523.us.us.3
  store double %.1524.us.us.3, ptr %sunkaddr431, align 8
  %sunkaddr435 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr436 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr435
  %sunkaddr437 = getelementptr i8, ptr %sunkaddr436, i64 32
  %.1514.us.us.4 = load double, ptr %sunkaddr437, align 8
  %sunkaddr438 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr439 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr438
  %sunkaddr440 = getelementptr i8, ptr %sunkaddr439, i64 32
  %.1523.us.us.4 = load double, ptr %sunkaddr440, align 8
  %.1524.us.us.4 = fadd double %.1514.us.us.4, %.1523.us.us.4
  store double %.1524.us.us.4, ptr %sunkaddr437, align 8
  %sunkaddr441 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr442 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr441
  %sunkaddr443 = getelementptr i8, ptr %sunkaddr442, i64 40
  %.1514.us.us.5 = load double, ptr %sunkaddr443, align 8
  %sunkaddr444 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr445 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr444
  %sunkaddr446 = getelementptr i8, ptr %sunkaddr445, i64 40
  %.1523.us.us.5 = load double, ptr %sunkaddr446, align 8
  %.1524.us.us.5 = fadd double %.1514.us.us.5, %.1523.us.us.5
  store double %.1524.us.us.5, ptr %sunkaddr443, align 8
  %sunkaddr447 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr448 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr447
  %sunkaddr449 = getelementptr i8, ptr %sunkaddr448, i64 48
  %.1514.us.us.6 = load double, ptr %sunkaddr449, align 8
  %sunkaddr450 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr451 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr450
  %sunkaddr452 = getelementptr i8, ptr %sunkaddr451, i64 48
  %.1523.us.us.6 = load double, ptr %sunkaddr452, align 8
  %.1524.us.us.6 = fadd double %.1514.us.us.6, %.1523.us.us.6
  store double %.1524.us.us.6, ptr %sunkaddr449, align 8
  %sunkaddr453 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr454 = getelementptr i8, ptr %.6.i.i18, i64 %sunkaddr453
  %sunkaddr455 = getelementptr i8, ptr %sunkaddr454, i64 56
  %.1514.us.us.7 = load double, ptr %sunkaddr455, align 8
  %sunkaddr456 = mul i64 %loop.index.2680.us.us, 8
  %sunkaddr457 = getelementptr i8, ptr %.6.i198, i64 %sunkaddr456
  %sunkaddr458 = getelementptr i8, ptr %sunkaddr457, i64 56
  %.1523.us.us.7 = load double, ptr %sunkaddr458, align 8
  %.1524.us.us.7 = fadd double %.1514.us.us.7, %.1523.us.us.7
  store double %.1524.us.us.7, ptr %sunkaddr455, align 8
  %.1529.us.us.7 = add nuw nsw i64 %loop.index.2680.us.us, 8
  %exitcond714.not.7 = icmp eq i64 %.99.fca.5.0.load.fr349, %.1529.us.us.7
  br i1 %exitcond714.not.7, label %for.body.3.lr.ph, label %for.body.2.us.us, !llvm.loop !201

for.body.2.lr.ph.split:                           ; preds = %for.end.endif.endif.endif.endif.endif.endif.endif
  %.1420 = load double, ptr %.6.i.i39, align 8
  %.6.i200 = fmul double %.1278, %.1420
  store double %.6.i200, ptr %.6.i198, align 8
  %.1514.us684.pre = load double, ptr %.6.i.i18, align 8
  %.1524.us688 = fadd double %.6.i200, %.1514.us684.pre
  store double %.1524.us688, ptr %.6.i.i18, align 8
  br label %for.body.3.lr.ph

for.body.3.lr.ph:                                 ; preds = %for.body.2.us.us, %middle.block498, %vec.epilog.middle.block512, %for.body.2.us.us.prol.loopexit, %for.body.2.lr.ph.split
  tail call void @NRT_incref(ptr nonnull %.7.i.i.i35)
  %.1579.not = icmp eq i64 %.99.fca.5.0.load.fr349, 1
  tail call void @NRT_decref(ptr nonnull %.7.i.i191)
  br i1 %.1579.not, label %.89.endif.preheader.i204.thread, label %iter.check518

iter.check518:                                    ; preds = %for.body.3.lr.ph
  %min.iters.check516 = icmp ult i64 %.99.fca.5.0.load.fr349, 4
  br i1 %min.iters.check516, label %for.body.3.us.preheader, label %vector.main.loop.iter.check520

vector.main.loop.iter.check520:                   ; preds = %iter.check518
  %min.iters.check519 = icmp ult i64 %.99.fca.5.0.load.fr349, 32
  br i1 %min.iters.check519, label %vec.epilog.ph539, label %vector.ph521

vector.ph521:                                     ; preds = %vector.main.loop.iter.check520
  %const_mat248 = add i64 %const, -24
  %n.vec523 = and i64 %.99.fca.5.0.load.fr349, %const_mat248
  %broadcast.splatinsert524 = insertelement <8 x double> poison, double %.13.i, i64 0
  %broadcast.splat525 = shufflevector <8 x double> %broadcast.splatinsert524, <8 x double> poison, <8 x i32> zeroinitializer
  br label %vector.body526

vector.body526:                                   ; preds = %vector.body526, %vector.ph521
  %index527 = phi i64 [ 0, %vector.ph521 ], [ %index.next532, %vector.body526 ]
  %sunkaddr467 = mul i64 %index527, 8
  %sunkaddr468 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr467
  %sunkaddr469 = getelementptr i8, ptr %sunkaddr468, i64 192
  %sunkaddr459 = mul i64 %index527, 8
  %sunkaddr460 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr459
  %wide.load528 = load <8 x double>, ptr %sunkaddr460, align 8
  %sunkaddr461 = mul i64 %index527, 8
  %sunkaddr462 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr461
  %sunkaddr463 = getelementptr i8, ptr %sunkaddr462, i64 64
  %wide.load529 = load <8 x double>, ptr %sunkaddr463, align 8
  %sunkaddr464 = mul i64 %index527, 8
  %sunkaddr465 = getelementptr i8, ptr %.6.i.i39, i64 %sunkaddr464
  %sunkaddr466 = getelementptr i8, ptr %sunkaddr465, i64 128
  %wide.load530 = load <8 x double>, ptr %sunkaddr466, align 8
  %wide.load531 = load <8 x double>, ptr %sunkaddr469, align 8
  %75 = fmul <8 x double> %broadcast.splat525, %wide.load528
  %76 = fmul <8 x double> %broadcast.splat525, %wide.load529
  %77 = fmul <8 x double> %broadcast.splat525, %wide.load530
  %78 = fmul <8 x double> %broadcast.splat525, %wide.load531
  store <8 x double> %75, ptr %sunkaddr460, align 8
  store <8 x double> %76, ptr %sunkaddr463, align 8
  store <8 x double> %77, ptr %sunkaddr466, align 8
  store <8 x double> %78, ptr %sunkaddr469, align 8
  %index.next532 = add nuw i64 %index527, 32
  %79 = icmp eq i64 %n.vec523, %index.next532
  br i1 %79, label %middle.block533, label %vector.body526, !llvm.loop !202

middle.block533:                                  ; preds = %vector.body526
  %cmp.n534 = icmp eq i64 %.99.fca.5.0.load.fr349, %n.vec523
  br i1 %cmp.n534, label %.89.endif.preheader.i204.thread27, label %vec.epilog.iter.check537

.89.endif.preheader.i204.thread27:                ; preds = %middle.block533
  %xtraiter.i20528 = and i64 %.99.fca.5.0.load.fr349, 7
  br label %.89.endif.preheader.new.i206

vec.epilog.iter.check537:                         ; preds = %middle.block533
  %n.mod.vf522 = and i64 %.99.fca.5.0.load.fr349, 28
  %min.epilog.iters.check538 = icmp eq i64 %n.mod.vf522, 0
  br i1 %min.epilog.iters.check538, label %for.body.3.us.preheader, label %vec.epilog.ph539, !prof !91

vec.epilog.ph539:                                 ; preds = %vec.epilog.iter.check537, %vector.main.loop.iter.check520
  %vec.epilog.resume.val535 = phi i64 [ %n.vec523, %vec.epilog.iter.check537 ], [ 0, %vector.main.loop.iter.check520 ]
  %const_mat251 = add i64 %const, 4
  %n.vec541 = and i64 %.99.fca.5.0.load.fr349, %const_mat251
  %broadcast.splatinsert542 = insertelement <4 x double> poison, double %.13.i, i64 0
  %broadcast.splat543 = shufflevector <4 x double> %broadcast.splatinsert542, <4 x double> poison, <4 x i32> zeroinitializer
  br label %vec.epilog.vector.body544

vec.epilog.vector.body544:                        ; preds = %vec.epilog.vector.body544, %vec.epilog.ph539
  %index545 = phi i64 [ %vec.epilog.resume.val535, %vec.epilog.ph539 ], [ %index.next547, %vec.epilog.vector.body544 ]
  %80 = shl i64 %index545, 3
  %scevgep76 = getelementptr i8, ptr %.6.i.i39, i64 %80
  %wide.load546 = load <4 x double>, ptr %scevgep76, align 8
  %81 = fmul <4 x double> %broadcast.splat543, %wide.load546
  store <4 x double> %81, ptr %scevgep76, align 8
  %index.next547 = add nuw i64 %index545, 4
  %82 = icmp eq i64 %n.vec541, %index.next547
  br i1 %82, label %vec.epilog.middle.block548, label %vec.epilog.vector.body544, !llvm.loop !203

vec.epilog.middle.block548:                       ; preds = %vec.epilog.vector.body544
  %cmp.n549 = icmp eq i64 %.99.fca.5.0.load.fr349, %n.vec541
  br i1 %cmp.n549, label %.89.endif.preheader.i204, label %for.body.3.us.preheader

for.body.3.us.preheader:                          ; preds = %vec.epilog.middle.block548, %vec.epilog.iter.check537, %iter.check518
  %loop.index.3695.us.ph = phi i64 [ %n.vec541, %vec.epilog.middle.block548 ], [ %n.vec523, %vec.epilog.iter.check537 ], [ 0, %iter.check518 ]
  br label %for.body.3.us

for.body.3.us:                                    ; preds = %for.body.3.us.preheader, %for.body.3.us
  %loop.index.3695.us = phi i64 [ %.1593.us, %for.body.3.us ], [ %loop.index.3695.us.ph, %for.body.3.us.preheader ]
  %83 = shl i64 %loop.index.3695.us, 3
  %scevgep75 = getelementptr i8, ptr %.6.i.i39, i64 %83
  %.1587.us = load double, ptr %scevgep75, align 8
  %.1588.us = fmul double %.13.i, %.1587.us
  store double %.1588.us, ptr %scevgep75, align 8
  %.1593.us = add nuw nsw i64 %loop.index.3695.us, 1
  %exitcond715.not = icmp eq i64 %.99.fca.5.0.load.fr349, %.1593.us
  br i1 %exitcond715.not, label %.89.endif.preheader.i204, label %for.body.3.us, !llvm.loop !204

.89.endif.preheader.i204.thread:                  ; preds = %for.body.3.lr.ph
  %.1587.pre = load double, ptr %.6.i.i39, align 8
  %.1588 = fmul double %.13.i, %.1587.pre
  store double %.1588, ptr %.6.i.i39, align 8
  br label %.89.endif.epil.preheader.i240

.89.endif.preheader.i204:                         ; preds = %for.body.3.us, %vec.epilog.middle.block548
  %xtraiter.i205 = and i64 %.99.fca.5.0.load.fr349, 7
  %84 = icmp samesign ult i64 %.99.fca.5.0.load.fr349, 8
  br i1 %84, label %.89.endif.epil.preheader.i240, label %.89.endif.preheader.new.i206, !prof !176

.89.endif.preheader.new.i206:                     ; preds = %.89.endif.preheader.i204.thread27, %.89.endif.preheader.i204
  %xtraiter.i20529 = phi i64 [ %xtraiter.i20528, %.89.endif.preheader.i204.thread27 ], [ %xtraiter.i205, %.89.endif.preheader.i204 ]
  %unroll_iter.i207 = and i64 %.99.fca.5.0.load.fr349, %const
  %85 = add nsw i64 %.99.fca.5.0.load.fr349, -8
  %86 = lshr i64 %85, 3
  %87 = add nuw nsw i64 %86, 1
  %xtraiter565 = and i64 %87, 3
  %88 = and i64 %85, 24
  %lcmp.mod566.not = icmp eq i64 %88, 24
  br i1 %lcmp.mod566.not, label %.89.endif.i208.preheader, label %.89.endif.i208.prol.preheader, !prof !107

.89.endif.i208.prol.preheader:                    ; preds = %.89.endif.preheader.new.i206
  br label %.89.endif.i208.prol

.89.endif.i208.prol:                              ; preds = %.89.endif.i208.prol.preheader, %.89.endif.i208.prol
  %lsr.iv73 = phi i64 [ %xtraiter565, %.89.endif.i208.prol.preheader ], [ %lsr.iv.next74, %.89.endif.i208.prol ]
  %.77.013.i210.prol = phi ptr [ %.114.7.i235.prol, %.89.endif.i208.prol ], [ %.6.i.i60, %.89.endif.i208.prol.preheader ]
  %.72.012.i211.prol = phi double [ %.108.7.i234.prol, %.89.endif.i208.prol ], [ 0.000000e+00, %.89.endif.i208.prol.preheader ]
  %.106.i212.prol = load double, ptr %.77.013.i210.prol, align 8, !noalias !205
  %.108.i213.prol = fadd double %.72.012.i211.prol, %.106.i212.prol
  %.114.i214.prol = getelementptr i8, ptr %.77.013.i210.prol, i64 8
  %.106.1.i215.prol = load double, ptr %.114.i214.prol, align 8, !noalias !205
  %.108.1.i216.prol = fadd double %.108.i213.prol, %.106.1.i215.prol
  %.114.1.i217.prol = getelementptr i8, ptr %.77.013.i210.prol, i64 16
  %.106.2.i218.prol = load double, ptr %.114.1.i217.prol, align 8, !noalias !205
  %.108.2.i219.prol = fadd double %.108.1.i216.prol, %.106.2.i218.prol
  %.114.2.i220.prol = getelementptr i8, ptr %.77.013.i210.prol, i64 24
  %.106.3.i221.prol = load double, ptr %.114.2.i220.prol, align 8, !noalias !205
  %.108.3.i222.prol = fadd double %.108.2.i219.prol, %.106.3.i221.prol
  %.114.3.i223.prol = getelementptr i8, ptr %.77.013.i210.prol, i64 32
  %.106.4.i224.prol = load double, ptr %.114.3.i223.prol, align 8, !noalias !205
  %.108.4.i225.prol = fadd double %.108.3.i222.prol, %.106.4.i224.prol
  %.114.4.i226.prol = getelementptr i8, ptr %.77.013.i210.prol, i64 40
  %.106.5.i227.prol = load double, ptr %.114.4.i226.prol, align 8, !noalias !205
  %.108.5.i228.prol = fadd double %.108.4.i225.prol, %.106.5.i227.prol
  %.114.5.i229.prol = getelementptr i8, ptr %.77.013.i210.prol, i64 48
  %.106.6.i230.prol = load double, ptr %.114.5.i229.prol, align 8, !noalias !205
  %.108.6.i231.prol = fadd double %.108.5.i228.prol, %.106.6.i230.prol
  %.114.6.i232.prol = getelementptr i8, ptr %.77.013.i210.prol, i64 56
  %.106.7.i233.prol = load double, ptr %.114.6.i232.prol, align 8, !noalias !205
  %.108.7.i234.prol = fadd double %.108.6.i231.prol, %.106.7.i233.prol
  %.114.7.i235.prol = getelementptr i8, ptr %.77.013.i210.prol, i64 64
  %lsr.iv.next74 = add i64 %lsr.iv73, -1
  %prol.iter567.cmp.not = icmp eq i64 %lsr.iv.next74, 0
  br i1 %prol.iter567.cmp.not, label %.89.endif.i208.prol.loopexit, label %.89.endif.i208.prol, !prof !111, !llvm.loop !208

.89.endif.i208.prol.loopexit:                     ; preds = %.89.endif.i208.prol
  %89 = shl nuw nsw i64 %xtraiter565, 6
  %scevgep56 = getelementptr i8, ptr %.6.i.i60, i64 %89
  %90 = shl nuw nsw i64 %xtraiter565, 3
  %91 = sub nsw i64 %unroll_iter.i207, %90
  %92 = icmp ult i64 %85, 24
  br i1 %92, label %common.ret.loopexit.unr-lcssa.i238, label %.89.endif.i208.preheader, !prof !113

.89.endif.i208.preheader:                         ; preds = %.89.endif.preheader.new.i206, %.89.endif.i208.prol.loopexit
  %lsr.iv.i209.ph = phi i64 [ %unroll_iter.i207, %.89.endif.preheader.new.i206 ], [ %91, %.89.endif.i208.prol.loopexit ]
  %.77.013.i210.ph = phi ptr [ %.6.i.i60, %.89.endif.preheader.new.i206 ], [ %scevgep56, %.89.endif.i208.prol.loopexit ]
  %.72.012.i211.ph = phi double [ 0.000000e+00, %.89.endif.preheader.new.i206 ], [ %.108.7.i234.prol, %.89.endif.i208.prol.loopexit ]
  br label %.89.endif.i208

common.ret.loopexit.unr-lcssa.i238:               ; preds = %.89.endif.i208, %.89.endif.i208.prol.loopexit
  %.108.7.i234.lcssa = phi double [ %.108.7.i234.prol, %.89.endif.i208.prol.loopexit ], [ %.108.7.i234.3, %.89.endif.i208 ]
  %.114.7.i235.lcssa = phi ptr [ %scevgep56, %.89.endif.i208.prol.loopexit ], [ %.114.7.i235.3, %.89.endif.i208 ]
  %lcmp.mod.not.i239 = icmp eq i64 %xtraiter.i20529, 0
  br i1 %lcmp.mod.not.i239, label %for.end.3.endif, label %.89.endif.epil.preheader.i240, !prof !114

.89.endif.epil.preheader.i240:                    ; preds = %common.ret.loopexit.unr-lcssa.i238, %.89.endif.preheader.i204, %.89.endif.preheader.i204.thread
  %xtraiter.i205434 = phi i64 [ %xtraiter.i205, %.89.endif.preheader.i204 ], [ %xtraiter.i20529, %common.ret.loopexit.unr-lcssa.i238 ], [ 1, %.89.endif.preheader.i204.thread ]
  %.77.013.epil.init.i241 = phi ptr [ %.6.i.i60, %.89.endif.preheader.i204 ], [ %.114.7.i235.lcssa, %common.ret.loopexit.unr-lcssa.i238 ], [ %.6.i.i60, %.89.endif.preheader.i204.thread ]
  %.72.012.epil.init.i242 = phi double [ 0.000000e+00, %.89.endif.preheader.i204 ], [ %.108.7.i234.lcssa, %common.ret.loopexit.unr-lcssa.i238 ], [ 0.000000e+00, %.89.endif.preheader.i204.thread ]
  br label %.89.endif.epil.i243

.89.endif.epil.i243:                              ; preds = %.89.endif.epil.i243, %.89.endif.epil.preheader.i240
  %.72.012.epil.i244 = phi double [ %.108.epil.i248, %.89.endif.epil.i243 ], [ %.72.012.epil.init.i242, %.89.endif.epil.preheader.i240 ]
  %epil.iter.i245 = phi i64 [ %epil.iter.next.i249, %.89.endif.epil.i243 ], [ 0, %.89.endif.epil.preheader.i240 ]
  %93 = shl i64 %epil.iter.i245, 3
  %scevgep72 = getelementptr i8, ptr %.77.013.epil.init.i241, i64 %93
  %.106.epil.i247 = load double, ptr %scevgep72, align 8, !noalias !205
  %.108.epil.i248 = fadd double %.72.012.epil.i244, %.106.epil.i247
  %epil.iter.next.i249 = add i64 %epil.iter.i245, 1
  %epil.iter.cmp.not.i250 = icmp eq i64 %xtraiter.i205434, %epil.iter.next.i249
  br i1 %epil.iter.cmp.not.i250, label %for.end.3.endif, label %.89.endif.epil.i243, !prof !115, !llvm.loop !116

.89.endif.i208:                                   ; preds = %.89.endif.i208.preheader, %.89.endif.i208
  %lsr.iv.i209 = phi i64 [ %lsr.iv.next.i236.3, %.89.endif.i208 ], [ %lsr.iv.i209.ph, %.89.endif.i208.preheader ]
  %.77.013.i210 = phi ptr [ %.114.7.i235.3, %.89.endif.i208 ], [ %.77.013.i210.ph, %.89.endif.i208.preheader ]
  %.72.012.i211 = phi double [ %.108.7.i234.3, %.89.endif.i208 ], [ %.72.012.i211.ph, %.89.endif.i208.preheader ]
  %.106.i212 = load double, ptr %.77.013.i210, align 8, !noalias !205
  %.108.i213 = fadd double %.72.012.i211, %.106.i212
  %.114.i214 = getelementptr i8, ptr %.77.013.i210, i64 8
  %.106.1.i215 = load double, ptr %.114.i214, align 8, !noalias !205
  %.108.1.i216 = fadd double %.108.i213, %.106.1.i215
  %.114.1.i217 = getelementptr i8, ptr %.77.013.i210, i64 16
  %.106.2.i218 = load double, ptr %.114.1.i217, align 8, !noalias !205
  %.108.2.i219 = fadd double %.108.1.i216, %.106.2.i218
  %.114.2.i220 = getelementptr i8, ptr %.77.013.i210, i64 24
  %.106.3.i221 = load double, ptr %.114.2.i220, align 8, !noalias !205
  %.108.3.i222 = fadd double %.108.2.i219, %.106.3.i221
  %.114.3.i223 = getelementptr i8, ptr %.77.013.i210, i64 32
  %.106.4.i224 = load double, ptr %.114.3.i223, align 8, !noalias !205
  %.108.4.i225 = fadd double %.108.3.i222, %.106.4.i224
  %.114.4.i226 = getelementptr i8, ptr %.77.013.i210, i64 40
  %.106.5.i227 = load double, ptr %.114.4.i226, align 8, !noalias !205
  %.108.5.i228 = fadd double %.108.4.i225, %.106.5.i227
  %.114.5.i229 = getelementptr i8, ptr %.77.013.i210, i64 48
  %.106.6.i230 = load double, ptr %.114.5.i229, align 8, !noalias !205
  %.108.6.i231 = fadd double %.108.5.i228, %.106.6.i230
  %.114.6.i232 = getelementptr i8, ptr %.77.013.i210, i64 56
  %.106.7.i233 = load double, ptr %.114.6.i232, align 8, !noalias !205
  %.108.7.i234 = fadd double %.108.6.i231, %.106.7.i233
  %.114.7.i235 = getelementptr i8, ptr %.77.013.i210, i64 64
  %.106.i212.1 = load double, ptr %.114.7.i235, align 8, !noalias !205
  %.108.i213.1 = fadd double %.108.7.i234, %.106.i212.1
  %.114.i214.1 = getelementptr i8, ptr %.77.013.i210, i64 72
  %.106.1.i215.1 = load double, ptr %.114.i214.1, align 8, !noalias !205
  %.108.1.i216.1 = fadd double %.108.i213.1, %.106.1.i215.1
  %.114.1.i217.1 = getelementptr i8, ptr %.77.013.i210, i64 80
  %.106.2.i218.1 = load double, ptr %.114.1.i217.1, align 8, !noalias !205
  %.108.2.i219.1 = fadd double %.108.1.i216.1, %.106.2.i218.1
  %.114.2.i220.1 = getelementptr i8, ptr %.77.013.i210, i64 88
  %.106.3.i221.1 = load double, ptr %.114.2.i220.1, align 8, !noalias !205
  %.108.3.i222.1 = fadd double %.108.2.i219.1, %.106.3.i221.1
  %.114.3.i223.1 = getelementptr i8, ptr %.77.013.i210, i64 96
  %.106.4.i224.1 = load double, ptr %.114.3.i223.1, align 8, !noalias !205
  %.108.4.i225.1 = fadd double %.108.3.i222.1, %.106.4.i224.1
  %.114.4.i226.1 = getelementptr i8, ptr %.77.013.i210, i64 104
  %.106.5.i227.1 = load double, ptr %.114.4.i226.1, align 8, !noalias !205
  %.108.5.i228.1 = fadd double %.108.4.i225.1, %.106.5.i227.1
  %.114.5.i229.1 = getelementptr i8, ptr %.77.013.i210, i64 112
  %.106.6.i230.1 = load double, ptr %.114.5.i229.1, align 8, !noalias !205
  %.108.6.i231.1 = fadd double %.108.5.i228.1, %.106.6.i230.1
  %.114.6.i232.1 = getelementptr i8, ptr %.77.013.i210, i64 120
  %.106.7.i233.1 = load double, ptr %.114.6.i232.1, align 8, !noalias !205
  %.108.7.i234.1 = fadd double %.108.6.i231.1, %.106.7.i233.1
  %.114.7.i235.1 = getelementptr i8, ptr %.77.013.i210, i64 128
  %.106.i212.2 = load double, ptr %.114.7.i235.1, align 8, !noalias !205
  %.108.i213.2 = fadd double %.108.7.i234.1, %.106.i212.2
  %.114.i214.2 = getelementptr i8, ptr %.77.013.i210, i64 136
  %.106.1.i215.2 = load double, ptr %.114.i214.2, align 8, !noalias !205
  %.108.1.i216.2 = fadd double %.108.i213.2, %.106.1.i215.2
  %.114.1.i217.2 = getelementptr i8, ptr %.77.013.i210, i64 144
  %.106.2.i218.2 = load double, ptr %.114.1.i217.2, align 8, !noalias !205
  %.108.2.i219.2 = fadd double %.108.1.i216.2, %.106.2.i218.2
  %.114.2.i220.2 = getelementptr i8, ptr %.77.013.i210, i64 152
  %.106.3.i221.2 = load double, ptr %.114.2.i220.2, align 8, !noalias !205
  %.108.3.i222.2 = fadd double %.108.2.i219.2, %.106.3.i221.2
  %.114.3.i223.2 = getelementptr i8, ptr %.77.013.i210, i64 160
  %.106.4.i224.2 = load double, ptr %.114.3.i223.2, align 8, !noalias !205
  %.108.4.i225.2 = fadd double %.108.3.i222.2, %.106.4.i224.2
  %.114.4.i226.2 = getelementptr i8, ptr %.77.013.i210, i64 168
  %.106.5.i227.2 = load double, ptr %.114.4.i226.2, align 8, !noalias !205
  %.108.5.i228.2 = fadd double %.108.4.i225.2, %.106.5.i227.2
  %.114.5.i229.2 = getelementptr i8, ptr %.77.013.i210, i64 176
  %.106.6.i230.2 = load double, ptr %.114.5.i229.2, align 8, !noalias !205
  %.108.6.i231.2 = fadd double %.108.5.i228.2, %.106.6.i230.2
  %.114.6.i232.2 = getelementptr i8, ptr %.77.013.i210, i64 184
  %.106.7.i233.2 = load double, ptr %.114.6.i232.2, align 8, !noalias !205
  %.108.7.i234.2 = fadd double %.108.6.i231.2, %.106.7.i233.2
  %.114.7.i235.2 = getelementptr i8, ptr %.77.013.i210, i64 192
  %.106.i212.3 = load double, ptr %.114.7.i235.2, align 8, !noalias !205
  %.108.i213.3 = fadd double %.108.7.i234.2, %.106.i212.3
  %.114.i214.3 = getelementptr i8, ptr %.77.013.i210, i64 200
  %.106.1.i215.3 = load double, ptr %.114.i214.3, align 8, !noalias !205
  %.108.1.i216.3 = fadd double %.108.i213.3, %.106.1.i215.3
  %.114.1.i217.3 = getelementptr i8, ptr %.77.013.i210, i64 208
  %.106.2.i218.3 = load double, ptr %.114.1.i217.3, align 8, !noalias !205
  %.108.2.i219.3 = fadd double %.108.1.i216.3, %.106.2.i218.3
  %.114.2.i220.3 = getelementptr i8, ptr %.77.013.i210, i64 216
  %.106.3.i221.3 = load double, ptr %.114.2.i220.3, align 8, !noalias !205
  %.108.3.i222.3 = fadd double %.108.2.i219.3, %.106.3.i221.3
  %.114.3.i223.3 = getelementptr i8, ptr %.77.013.i210, i64 224
  %.106.4.i224.3 = load double, ptr %.114.3.i223.3, align 8, !noalias !205
  %.108.4.i225.3 = fadd double %.108.3.i222.3, %.106.4.i224.3
  %.114.4.i226.3 = getelementptr i8, ptr %.77.013.i210, i64 232
  %.106.5.i227.3 = load double, ptr %.114.4.i226.3, align 8, !noalias !205
  %.108.5.i228.3 = fadd double %.108.4.i225.3, %.106.5.i227.3
  %.114.5.i229.3 = getelementptr i8, ptr %.77.013.i210, i64 240
  %.106.6.i230.3 = load double, ptr %.114.5.i229.3, align 8, !noalias !205
  %.108.6.i231.3 = fadd double %.108.5.i228.3, %.106.6.i230.3
  %.114.6.i232.3 = getelementptr i8, ptr %.77.013.i210, i64 248
  %.106.7.i233.3 = load double, ptr %.114.6.i232.3, align 8, !noalias !205
  %.108.7.i234.3 = fadd double %.108.6.i231.3, %.106.7.i233.3
  %.114.7.i235.3 = getelementptr i8, ptr %.77.013.i210, i64 256
  %lsr.iv.next.i236.3 = add nsw i64 %lsr.iv.i209, -32
  %niter.ncmp.7.i237.3 = icmp eq i64 %lsr.iv.next.i236.3, 0
  br i1 %niter.ncmp.7.i237.3, label %common.ret.loopexit.unr-lcssa.i238, label %.89.endif.i208, !prof !118, !llvm.loop !209

for.end.3.endif.critedge:                         ; preds = %for.end.endif.endif.endif.endif.endif.endif.endif
  tail call void @NRT_incref(ptr nonnull %.7.i.i.i35)
  tail call void @NRT_decref(ptr nonnull %.7.i.i191)
  br label %for.end.3.endif

for.end.3.endif:                                  ; preds = %.89.endif.epil.i243, %for.end.3.endif.critedge, %common.ret.loopexit.unr-lcssa.i238
  %.72.0.lcssa.i203 = phi double [ 0.000000e+00, %for.end.3.endif.critedge ], [ %.108.7.i234.lcssa, %common.ret.loopexit.unr-lcssa.i238 ], [ %.108.epil.i248, %.89.endif.epil.i243 ]
  %94 = icmp eq i64 %.99.fca.5.0.load.fr349, 0
  tail call void @NRT_incref(ptr nonnull %.7.i.i.i14)
  tail call void @NRT_decref(ptr nonnull %.7.i.i.i35)
  br i1 %94, label %for.end.3.endif.endif.endif, label %.89.endif.preheader.i255, !prof !210

.89.endif.preheader.i255:                         ; preds = %for.end.3.endif
  %xtraiter.i256 = and i64 %.99.fca.5.0.load.fr349, 7
  %95 = icmp samesign ult i64 %.99.fca.5.0.load.fr349, 8
  br i1 %95, label %.89.endif.epil.preheader.i291, label %.89.endif.preheader.new.i257, !prof !106

.89.endif.preheader.new.i257:                     ; preds = %.89.endif.preheader.i255
  %unroll_iter.i258 = and i64 %.99.fca.5.0.load.fr349, %const
  %96 = add nsw i64 %.99.fca.5.0.load.fr349, -8
  %97 = lshr i64 %96, 3
  %98 = add nuw nsw i64 %97, 1
  %xtraiter568 = and i64 %98, 3
  %99 = and i64 %96, 24
  %lcmp.mod569.not = icmp eq i64 %99, 24
  br i1 %lcmp.mod569.not, label %.89.endif.i259.preheader, label %.89.endif.i259.prol.preheader, !prof !107

.89.endif.i259.prol.preheader:                    ; preds = %.89.endif.preheader.new.i257
  br label %.89.endif.i259.prol

.89.endif.i259.prol:                              ; preds = %.89.endif.i259.prol.preheader, %.89.endif.i259.prol
  %lsr.iv = phi i64 [ %xtraiter568, %.89.endif.i259.prol.preheader ], [ %lsr.iv.next, %.89.endif.i259.prol ]
  %.77.013.i261.prol = phi ptr [ %.114.7.i286.prol, %.89.endif.i259.prol ], [ %.6.i.i18, %.89.endif.i259.prol.preheader ]
  %.72.012.i262.prol = phi double [ %.108.7.i285.prol, %.89.endif.i259.prol ], [ 0.000000e+00, %.89.endif.i259.prol.preheader ]
  %.106.i263.prol = load double, ptr %.77.013.i261.prol, align 8, !noalias !211
  %.108.i264.prol = fadd double %.72.012.i262.prol, %.106.i263.prol
  %.114.i265.prol = getelementptr i8, ptr %.77.013.i261.prol, i64 8
  %.106.1.i266.prol = load double, ptr %.114.i265.prol, align 8, !noalias !211
  %.108.1.i267.prol = fadd double %.108.i264.prol, %.106.1.i266.prol
  %.114.1.i268.prol = getelementptr i8, ptr %.77.013.i261.prol, i64 16
  %.106.2.i269.prol = load double, ptr %.114.1.i268.prol, align 8, !noalias !211
  %.108.2.i270.prol = fadd double %.108.1.i267.prol, %.106.2.i269.prol
  %.114.2.i271.prol = getelementptr i8, ptr %.77.013.i261.prol, i64 24
  %.106.3.i272.prol = load double, ptr %.114.2.i271.prol, align 8, !noalias !211
  %.108.3.i273.prol = fadd double %.108.2.i270.prol, %.106.3.i272.prol
  %.114.3.i274.prol = getelementptr i8, ptr %.77.013.i261.prol, i64 32
  %.106.4.i275.prol = load double, ptr %.114.3.i274.prol, align 8, !noalias !211
  %.108.4.i276.prol = fadd double %.108.3.i273.prol, %.106.4.i275.prol
  %.114.4.i277.prol = getelementptr i8, ptr %.77.013.i261.prol, i64 40
  %.106.5.i278.prol = load double, ptr %.114.4.i277.prol, align 8, !noalias !211
  %.108.5.i279.prol = fadd double %.108.4.i276.prol, %.106.5.i278.prol
  %.114.5.i280.prol = getelementptr i8, ptr %.77.013.i261.prol, i64 48
  %.106.6.i281.prol = load double, ptr %.114.5.i280.prol, align 8, !noalias !211
  %.108.6.i282.prol = fadd double %.108.5.i279.prol, %.106.6.i281.prol
  %.114.6.i283.prol = getelementptr i8, ptr %.77.013.i261.prol, i64 56
  %.106.7.i284.prol = load double, ptr %.114.6.i283.prol, align 8, !noalias !211
  %.108.7.i285.prol = fadd double %.108.6.i282.prol, %.106.7.i284.prol
  %.114.7.i286.prol = getelementptr i8, ptr %.77.013.i261.prol, i64 64
  %lsr.iv.next = add i64 %lsr.iv, -1
  %prol.iter570.cmp.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %prol.iter570.cmp.not, label %.89.endif.i259.prol.loopexit, label %.89.endif.i259.prol, !prof !111, !llvm.loop !214

.89.endif.i259.prol.loopexit:                     ; preds = %.89.endif.i259.prol
  %100 = shl nuw nsw i64 %xtraiter568, 6
  %scevgep57 = getelementptr i8, ptr %.6.i.i18, i64 %100
  %101 = shl nuw nsw i64 %xtraiter568, 3
  %102 = sub nsw i64 %unroll_iter.i258, %101
  %103 = icmp ult i64 %96, 24
  br i1 %103, label %common.ret.loopexit.unr-lcssa.i289, label %.89.endif.i259.preheader, !prof !113

.89.endif.i259.preheader:                         ; preds = %.89.endif.preheader.new.i257, %.89.endif.i259.prol.loopexit
  %lsr.iv.i260.ph = phi i64 [ %unroll_iter.i258, %.89.endif.preheader.new.i257 ], [ %102, %.89.endif.i259.prol.loopexit ]
  %.77.013.i261.ph = phi ptr [ %.6.i.i18, %.89.endif.preheader.new.i257 ], [ %scevgep57, %.89.endif.i259.prol.loopexit ]
  %.72.012.i262.ph = phi double [ 0.000000e+00, %.89.endif.preheader.new.i257 ], [ %.108.7.i285.prol, %.89.endif.i259.prol.loopexit ]
  br label %.89.endif.i259

common.ret.loopexit.unr-lcssa.i289:               ; preds = %.89.endif.i259, %.89.endif.i259.prol.loopexit
  %.108.7.i285.lcssa = phi double [ %.108.7.i285.prol, %.89.endif.i259.prol.loopexit ], [ %.108.7.i285.3, %.89.endif.i259 ]
  %.114.7.i286.lcssa = phi ptr [ %scevgep57, %.89.endif.i259.prol.loopexit ], [ %.114.7.i286.3, %.89.endif.i259 ]
  %lcmp.mod.not.i290 = icmp eq i64 %xtraiter.i256, 0
  br i1 %lcmp.mod.not.i290, label %for.end.3.endif.endif.endif, label %.89.endif.epil.preheader.i291, !prof !114

.89.endif.epil.preheader.i291:                    ; preds = %common.ret.loopexit.unr-lcssa.i289, %.89.endif.preheader.i255
  %.77.013.epil.init.i292 = phi ptr [ %.6.i.i18, %.89.endif.preheader.i255 ], [ %.114.7.i286.lcssa, %common.ret.loopexit.unr-lcssa.i289 ]
  %.72.012.epil.init.i293 = phi double [ 0.000000e+00, %.89.endif.preheader.i255 ], [ %.108.7.i285.lcssa, %common.ret.loopexit.unr-lcssa.i289 ]
  br label %.89.endif.epil.i294

.89.endif.epil.i294:                              ; preds = %.89.endif.epil.i294, %.89.endif.epil.preheader.i291
  %.72.012.epil.i295 = phi double [ %.108.epil.i299, %.89.endif.epil.i294 ], [ %.72.012.epil.init.i293, %.89.endif.epil.preheader.i291 ]
  %epil.iter.i296 = phi i64 [ %epil.iter.next.i300, %.89.endif.epil.i294 ], [ 0, %.89.endif.epil.preheader.i291 ]
  %104 = shl i64 %epil.iter.i296, 3
  %scevgep71 = getelementptr i8, ptr %.77.013.epil.init.i292, i64 %104
  %.106.epil.i298 = load double, ptr %scevgep71, align 8, !noalias !211
  %.108.epil.i299 = fadd double %.72.012.epil.i295, %.106.epil.i298
  %epil.iter.next.i300 = add i64 %epil.iter.i296, 1
  %epil.iter.cmp.not.i301 = icmp eq i64 %xtraiter.i256, %epil.iter.next.i300
  br i1 %epil.iter.cmp.not.i301, label %for.end.3.endif.endif.endif, label %.89.endif.epil.i294, !prof !115, !llvm.loop !116

.89.endif.i259:                                   ; preds = %.89.endif.i259.preheader, %.89.endif.i259
  %lsr.iv.i260 = phi i64 [ %lsr.iv.next.i287.3, %.89.endif.i259 ], [ %lsr.iv.i260.ph, %.89.endif.i259.preheader ]
  %.77.013.i261 = phi ptr [ %.114.7.i286.3, %.89.endif.i259 ], [ %.77.013.i261.ph, %.89.endif.i259.preheader ]
  %.72.012.i262 = phi double [ %.108.7.i285.3, %.89.endif.i259 ], [ %.72.012.i262.ph, %.89.endif.i259.preheader ]
  %.106.i263 = load double, ptr %.77.013.i261, align 8, !noalias !211
  %.108.i264 = fadd double %.72.012.i262, %.106.i263
  %.114.i265 = getelementptr i8, ptr %.77.013.i261, i64 8
  %.106.1.i266 = load double, ptr %.114.i265, align 8, !noalias !211
  %.108.1.i267 = fadd double %.108.i264, %.106.1.i266
  %.114.1.i268 = getelementptr i8, ptr %.77.013.i261, i64 16
  %.106.2.i269 = load double, ptr %.114.1.i268, align 8, !noalias !211
  %.108.2.i270 = fadd double %.108.1.i267, %.106.2.i269
  %.114.2.i271 = getelementptr i8, ptr %.77.013.i261, i64 24
  %.106.3.i272 = load double, ptr %.114.2.i271, align 8, !noalias !211
  %.108.3.i273 = fadd double %.108.2.i270, %.106.3.i272
  %.114.3.i274 = getelementptr i8, ptr %.77.013.i261, i64 32
  %.106.4.i275 = load double, ptr %.114.3.i274, align 8, !noalias !211
  %.108.4.i276 = fadd double %.108.3.i273, %.106.4.i275
  %.114.4.i277 = getelementptr i8, ptr %.77.013.i261, i64 40
  %.106.5.i278 = load double, ptr %.114.4.i277, align 8, !noalias !211
  %.108.5.i279 = fadd double %.108.4.i276, %.106.5.i278
  %.114.5.i280 = getelementptr i8, ptr %.77.013.i261, i64 48
  %.106.6.i281 = load double, ptr %.114.5.i280, align 8, !noalias !211
  %.108.6.i282 = fadd double %.108.5.i279, %.106.6.i281
  %.114.6.i283 = getelementptr i8, ptr %.77.013.i261, i64 56
  %.106.7.i284 = load double, ptr %.114.6.i283, align 8, !noalias !211
  %.108.7.i285 = fadd double %.108.6.i282, %.106.7.i284
  %.114.7.i286 = getelementptr i8, ptr %.77.013.i261, i64 64
  %.106.i263.1 = load double, ptr %.114.7.i286, align 8, !noalias !211
  %.108.i264.1 = fadd double %.108.7.i285, %.106.i263.1
  %.114.i265.1 = getelementptr i8, ptr %.77.013.i261, i64 72
  %.106.1.i266.1 = load double, ptr %.114.i265.1, align 8, !noalias !211
  %.108.1.i267.1 = fadd double %.108.i264.1, %.106.1.i266.1
  %.114.1.i268.1 = getelementptr i8, ptr %.77.013.i261, i64 80
  %.106.2.i269.1 = load double, ptr %.114.1.i268.1, align 8, !noalias !211
  %.108.2.i270.1 = fadd double %.108.1.i267.1, %.106.2.i269.1
  %.114.2.i271.1 = getelementptr i8, ptr %.77.013.i261, i64 88
  %.106.3.i272.1 = load double, ptr %.114.2.i271.1, align 8, !noalias !211
  %.108.3.i273.1 = fadd double %.108.2.i270.1, %.106.3.i272.1
  %.114.3.i274.1 = getelementptr i8, ptr %.77.013.i261, i64 96
  %.106.4.i275.1 = load double, ptr %.114.3.i274.1, align 8, !noalias !211
  %.108.4.i276.1 = fadd double %.108.3.i273.1, %.106.4.i275.1
  %.114.4.i277.1 = getelementptr i8, ptr %.77.013.i261, i64 104
  %.106.5.i278.1 = load double, ptr %.114.4.i277.1, align 8, !noalias !211
  %.108.5.i279.1 = fadd double %.108.4.i276.1, %.106.5.i278.1
  %.114.5.i280.1 = getelementptr i8, ptr %.77.013.i261, i64 112
  %.106.6.i281.1 = load double, ptr %.114.5.i280.1, align 8, !noalias !211
  %.108.6.i282.1 = fadd double %.108.5.i279.1, %.106.6.i281.1
  %.114.6.i283.1 = getelementptr i8, ptr %.77.013.i261, i64 120
  %.106.7.i284.1 = load double, ptr %.114.6.i283.1, align 8, !noalias !211
  %.108.7.i285.1 = fadd double %.108.6.i282.1, %.106.7.i284.1
  %.114.7.i286.1 = getelementptr i8, ptr %.77.013.i261, i64 128
  %.106.i263.2 = load double, ptr %.114.7.i286.1, align 8, !noalias !211
  %.108.i264.2 = fadd double %.108.7.i285.1, %.106.i263.2
  %.114.i265.2 = getelementptr i8, ptr %.77.013.i261, i64 136
  %.106.1.i266.2 = load double, ptr %.114.i265.2, align 8, !noalias !211
  %.108.1.i267.2 = fadd double %.108.i264.2, %.106.1.i266.2
  %.114.1.i268.2 = getelementptr i8, ptr %.77.013.i261, i64 144
  %.106.2.i269.2 = load double, ptr %.114.1.i268.2, align 8, !noalias !211
  %.108.2.i270.2 = fadd double %.108.1.i267.2, %.106.2.i269.2
  %.114.2.i271.2 = getelementptr i8, ptr %.77.013.i261, i64 152
  %.106.3.i272.2 = load double, ptr %.114.2.i271.2, align 8, !noalias !211
  %.108.3.i273.2 = fadd double %.108.2.i270.2, %.106.3.i272.2
  %.114.3.i274.2 = getelementptr i8, ptr %.77.013.i261, i64 160
  %.106.4.i275.2 = load double, ptr %.114.3.i274.2, align 8, !noalias !211
  %.108.4.i276.2 = fadd double %.108.3.i273.2, %.106.4.i275.2
  %.114.4.i277.2 = getelementptr i8, ptr %.77.013.i261, i64 168
  %.106.5.i278.2 = load double, ptr %.114.4.i277.2, align 8, !noalias !211
  %.108.5.i279.2 = fadd double %.108.4.i276.2, %.106.5.i278.2
  %.114.5.i280.2 = getelementptr i8, ptr %.77.013.i261, i64 176
  %.106.6.i281.2 = load double, ptr %.114.5.i280.2, align 8, !noalias !211
  %.108.6.i282.2 = fadd double %.108.5.i279.2, %.106.6.i281.2
  %.114.6.i283.2 = getelementptr i8, ptr %.77.013.i261, i64 184
  %.106.7.i284.2 = load double, ptr %.114.6.i283.2, align 8, !noalias !211
  %.108.7.i285.2 = fadd double %.108.6.i282.2, %.106.7.i284.2
  %.114.7.i286.2 = getelementptr i8, ptr %.77.013.i261, i64 192
  %.106.i263.3 = load double, ptr %.114.7.i286.2, align 8, !noalias !211
  %.108.i264.3 = fadd double %.108.7.i285.2, %.106.i263.3
  %.114.i265.3 = getelementptr i8, ptr %.77.013.i261, i64 200
  %.106.1.i266.3 = load double, ptr %.114.i265.3, align 8, !noalias !211
  %.108.1.i267.3 = fadd double %.108.i264.3, %.106.1.i266.3
  %.114.1.i268.3 = getelementptr i8, ptr %.77.013.i261, i64 208
  %.106.2.i269.3 = load double, ptr %.114.1.i268.3, align 8, !noalias !211
  %.108.2.i270.3 = fadd double %.108.1.i267.3, %.106.2.i269.3
  %.114.2.i271.3 = getelementptr i8, ptr %.77.013.i261, i64 216
  %.106.3.i272.3 = load double, ptr %.114.2.i271.3, align 8, !noalias !211
  %.108.3.i273.3 = fadd double %.108.2.i270.3, %.106.3.i272.3
  %.114.3.i274.3 = getelementptr i8, ptr %.77.013.i261, i64 224
  %.106.4.i275.3 = load double, ptr %.114.3.i274.3, align 8, !noalias !211
  %.108.4.i276.3 = fadd double %.108.3.i273.3, %.106.4.i275.3
  %.114.4.i277.3 = getelementptr i8, ptr %.77.013.i261, i64 232
  %.106.5.i278.3 = load double, ptr %.114.4.i277.3, align 8, !noalias !211
  %.108.5.i279.3 = fadd double %.108.4.i276.3, %.106.5.i278.3
  %.114.5.i280.3 = getelementptr i8, ptr %.77.013.i261, i64 240
  %.106.6.i281.3 = load double, ptr %.114.5.i280.3, align 8, !noalias !211
  %.108.6.i282.3 = fadd double %.108.5.i279.3, %.106.6.i281.3
  %.114.6.i283.3 = getelementptr i8, ptr %.77.013.i261, i64 248
  %.106.7.i284.3 = load double, ptr %.114.6.i283.3, align 8, !noalias !211
  %.108.7.i285.3 = fadd double %.108.6.i282.3, %.106.7.i284.3
  %.114.7.i286.3 = getelementptr i8, ptr %.77.013.i261, i64 256
  %lsr.iv.next.i287.3 = add nsw i64 %lsr.iv.i260, -32
  %niter.ncmp.7.i288.3 = icmp eq i64 %lsr.iv.next.i287.3, 0
  br i1 %niter.ncmp.7.i288.3, label %common.ret.loopexit.unr-lcssa.i289, label %.89.endif.i259, !prof !118, !llvm.loop !215

for.end.3.endif.endif.endif:                      ; preds = %.89.endif.epil.i294, %common.ret.loopexit.unr-lcssa.i289, %for.end.3.endif
  %.72.0.lcssa.i254 = phi double [ 0.000000e+00, %for.end.3.endif ], [ %.108.7.i285.lcssa, %common.ret.loopexit.unr-lcssa.i289 ], [ %.108.epil.i299, %.89.endif.epil.i294 ]
  tail call void @NRT_decref(ptr nonnull %.7.i.i.i56)
  tail call void @NRT_decref(ptr %arg.form.1.0)
  tail call void @NRT_decref(ptr %arg.form.2.0)
  %.1601 = fmul double %.72.0.lcssa.i, %.1278
  %.1642 = fadd double %arg.form.0, %.72.0.lcssa.i203
  %.1646 = fdiv double %.1601, %.1642
  %.1689 = fadd double %arg.form.0, %.72.0.lcssa.i254
  %.1693 = fdiv double 1.000000e+00, %.1689
  store ptr %.7.i.i.i, ptr %retptr, align 8
  %retptr.repack627 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store ptr null, ptr %retptr.repack627, align 8
  %retptr.repack629 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store i64 %.99.fca.5.0.load.fr349, ptr %retptr.repack629, align 8
  %retptr.repack631 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store i64 8, ptr %retptr.repack631, align 8
  %retptr.repack633 = getelementptr inbounds nuw i8, ptr %retptr, i64 32
  store ptr %.6.i.i, ptr %retptr.repack633, align 8
  %retptr.repack635 = getelementptr inbounds nuw i8, ptr %retptr, i64 40
  store i64 %.99.fca.5.0.load.fr349, ptr %retptr.repack635, align 8
  %retptr.repack637 = getelementptr inbounds nuw i8, ptr %retptr, i64 48
  store i64 8, ptr %retptr.repack637, align 8
  %retptr.repack617 = getelementptr inbounds nuw i8, ptr %retptr, i64 56
  store ptr %.7.i.i.i14, ptr %retptr.repack617, align 8
  %retptr.repack617.repack639 = getelementptr inbounds nuw i8, ptr %retptr, i64 64
  store ptr null, ptr %retptr.repack617.repack639, align 8
  %retptr.repack617.repack641 = getelementptr inbounds nuw i8, ptr %retptr, i64 72
  store i64 %.99.fca.5.0.load.fr349, ptr %retptr.repack617.repack641, align 8
  %retptr.repack617.repack643 = getelementptr inbounds nuw i8, ptr %retptr, i64 80
  store i64 8, ptr %retptr.repack617.repack643, align 8
  %retptr.repack617.repack645 = getelementptr inbounds nuw i8, ptr %retptr, i64 88
  store ptr %.6.i.i18, ptr %retptr.repack617.repack645, align 8
  %retptr.repack617.repack647 = getelementptr inbounds nuw i8, ptr %retptr, i64 96
  store i64 %.99.fca.5.0.load.fr349, ptr %retptr.repack617.repack647, align 8
  %retptr.repack617.repack649 = getelementptr inbounds nuw i8, ptr %retptr, i64 104
  store i64 8, ptr %retptr.repack617.repack649, align 8
  %retptr.repack619 = getelementptr inbounds nuw i8, ptr %retptr, i64 112
  store ptr %.7.i.i.i35, ptr %retptr.repack619, align 8
  %retptr.repack619.repack651 = getelementptr inbounds nuw i8, ptr %retptr, i64 120
  store ptr null, ptr %retptr.repack619.repack651, align 8
  %retptr.repack619.repack653 = getelementptr inbounds nuw i8, ptr %retptr, i64 128
  store i64 %.99.fca.5.0.load.fr349, ptr %retptr.repack619.repack653, align 8
  %retptr.repack619.repack655 = getelementptr inbounds nuw i8, ptr %retptr, i64 136
  store i64 8, ptr %retptr.repack619.repack655, align 8
  %retptr.repack619.repack657 = getelementptr inbounds nuw i8, ptr %retptr, i64 144
  store ptr %.6.i.i39, ptr %retptr.repack619.repack657, align 8
  %retptr.repack619.repack659 = getelementptr inbounds nuw i8, ptr %retptr, i64 152
  store i64 %.99.fca.5.0.load.fr349, ptr %retptr.repack619.repack659, align 8
  %retptr.repack619.repack661 = getelementptr inbounds nuw i8, ptr %retptr, i64 160
  store i64 8, ptr %retptr.repack619.repack661, align 8
  %retptr.repack621 = getelementptr inbounds nuw i8, ptr %retptr, i64 168
  store double %.1693, ptr %retptr.repack621, align 8
  %retptr.repack623 = getelementptr inbounds nuw i8, ptr %retptr, i64 176
  store double %.1646, ptr %retptr.repack623, align 8
  %retptr.repack625 = getelementptr inbounds nuw i8, ptr %retptr, i64 184
  store double %.13.i, ptr %retptr.repack625, align 8
  tail call void @NRT_decref(ptr nonnull %.7.i.i.i14)
  br label %common.ret
}

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: write)
define linkonce_odr noundef i32 @_ZN18elastomer_friction7kernels8rheology5prony7momentsB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd(ptr noalias writeonly captures(none) initializes((0, 24)) %retptr, ptr noalias readnone captures(none) %excinfo, double %arg.x) local_unnamed_addr #6 {
B0:
  %.8 = fcmp ogt double %arg.x, 1.000000e-01
  %.11 = fneg double %arg.x
  br i1 %.8, label %B16, label %B100.endif.endif

B16:                                              ; preds = %B0
  %.12 = tail call double @expm1(double %.11)
  %.13 = fneg double %.12
  %.18 = fdiv double %.13, %arg.x
  %.19 = fsub double 1.000000e+00, %.18
  %.27 = fadd double %.12, 1.000000e+00
  %.28 = fsub double %.18, %.27
  br label %common.ret

common.ret:                                       ; preds = %B100.endif.endif, %B16
  %.13.sink = phi double [ %.13, %B16 ], [ %.206, %B100.endif.endif ]
  %.19.sink = phi double [ %.19, %B16 ], [ %.180.10, %B100.endif.endif ]
  %.28.sink = phi double [ %.28, %B16 ], [ %.186.10, %B100.endif.endif ]
  store double %.13.sink, ptr %retptr, align 8
  %retptr.repack42 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store double %.19.sink, ptr %retptr.repack42, align 8
  %retptr.repack44 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store double %.28.sink, ptr %retptr.repack44, align 8
  ret i32 0

B100.endif.endif:                                 ; preds = %B0
  %.178 = fmul double %arg.x, 5.000000e-01
  %.180 = fadd double %.178, 0.000000e+00
  %.191 = fmul double %.178, %.11
  %.178.1 = fdiv double %.191, 3.000000e+00
  %.180.1 = fadd double %.180, %.178.1
  %.184.1 = fmul double %.178.1, 2.000000e+00
  %.186.1 = fadd double %.180, %.184.1
  %.191.1 = fmul double %.178.1, %.11
  %.178.2 = fmul double %.191.1, 2.500000e-01
  %.180.2 = fadd double %.180.1, %.178.2
  %.184.2 = fmul double %.178.2, 3.000000e+00
  %.186.2 = fadd double %.186.1, %.184.2
  %.191.2 = fmul double %.178.2, %.11
  %.178.3 = fdiv double %.191.2, 5.000000e+00
  %.180.3 = fadd double %.180.2, %.178.3
  %.184.3 = fmul double %.178.3, 4.000000e+00
  %.186.3 = fadd double %.186.2, %.184.3
  %.191.3 = fmul double %.178.3, %.11
  %.178.4 = fdiv double %.191.3, 6.000000e+00
  %.180.4 = fadd double %.180.3, %.178.4
  %.184.4 = fmul double %.178.4, 5.000000e+00
  %.186.4 = fadd double %.186.3, %.184.4
  %.191.4 = fmul double %.178.4, %.11
  %.178.5 = fdiv double %.191.4, 7.000000e+00
  %.180.5 = fadd double %.180.4, %.178.5
  %.184.5 = fmul double %.178.5, 6.000000e+00
  %.186.5 = fadd double %.186.4, %.184.5
  %.191.5 = fmul double %.178.5, %.11
  %.178.6 = fmul double %.191.5, 1.250000e-01
  %.180.6 = fadd double %.180.5, %.178.6
  %.184.6 = fmul double %.178.6, 7.000000e+00
  %.186.6 = fadd double %.186.5, %.184.6
  %.191.6 = fmul double %.178.6, %.11
  %.178.7 = fdiv double %.191.6, 9.000000e+00
  %.180.7 = fadd double %.180.6, %.178.7
  %.184.7 = fmul double %.178.7, 8.000000e+00
  %.186.7 = fadd double %.186.6, %.184.7
  %.191.7 = fmul double %.178.7, %.11
  %.178.8 = fdiv double %.191.7, 1.000000e+01
  %.180.8 = fadd double %.180.7, %.178.8
  %.184.8 = fmul double %.178.8, 9.000000e+00
  %.186.8 = fadd double %.186.7, %.184.8
  %.191.8 = fmul double %.178.8, %.11
  %.178.9 = fdiv double %.191.8, 1.100000e+01
  %.180.9 = fadd double %.180.8, %.178.9
  %.184.9 = fmul double %.178.9, 1.000000e+01
  %.186.9 = fadd double %.186.8, %.184.9
  %.191.9 = fmul double %.178.9, %.11
  %.178.10 = fdiv double %.191.9, 1.200000e+01
  %.180.10 = fadd double %.180.9, %.178.10
  %.184.10 = fmul double %.178.10, 1.100000e+01
  %.186.10 = fadd double %.186.9, %.184.10
  %.205 = tail call double @expm1(double %.11)
  %.206 = fneg double %.205
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.exp.f64(double) #1

define linkonce_odr range(i32 0, 2) i32 @_ZN5numba2np9arraymath7npy_max12_3clocals_3e8impl_maxB3v18B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, ptr %arg.a.0, ptr readnone captures(none) %arg.a.1, i64 %arg.a.2, i64 %arg.a.3, ptr %arg.a.4, i64 %arg.a.5.0, i64 %arg.a.6.0) local_unnamed_addr {
B0:
  %.19.i.i = alloca { ptr, ptr, i64, i64, ptr, [0 x i64], [0 x i64] }, align 8
  %.23.i.i = alloca [1 x i64], align 8
  %.79.i.i = alloca [1 x i64], align 8
  tail call void @NRT_incref(ptr %arg.a.0)
  %.25 = icmp eq i64 %arg.a.2, 0
  br i1 %.25, label %B28, label %B58.endif

common.ret:                                       ; preds = %end.endif.endif.if.if, %B300.critedge, %B262, %B188, %B28
  %common.ret.op = phi i32 [ 1, %B28 ], [ 0, %B188 ], [ 0, %B262 ], [ 0, %B300.critedge ], [ 1, %end.endif.endif.if.if ]
  ret i32 %common.ret.op

B28:                                              ; preds = %B0
  tail call void @NRT_decref(ptr %arg.a.0)
  store ptr @.const.picklebuf.e8300ab22a452ebe34461c60166a3da7fccf8c92, ptr %excinfo, align 8, !numba_exception_output !216
  br label %common.ret

B188:                                             ; preds = %end.endif.endif.endif
  tail call void @NRT_decref(ptr %arg.a.0)
  store double %.119.i, ptr %retptr, align 8
  br label %common.ret

B192:                                             ; preds = %end.endif.endif.endif
  %0 = icmp sgt i64 %arg.a.2, 1
  br i1 %0, label %B196.endif.preheader, label %B300.critedge, !prof !107

B196.endif.preheader:                             ; preds = %B192
  br label %B196.endif

B262:                                             ; preds = %B196.endif
  tail call void @NRT_decref(ptr %arg.a.0)
  store double %.434, ptr %retptr, align 8
  br label %common.ret

B196.backedge:                                    ; preds = %B196.endif
  %.380 = add nuw i64 %.380254258, 1
  %.6.i.inv = fcmp ogt double %.434, %max_value.2.0259
  %max_value.2.0..434 = select i1 %.6.i.inv, double %.434, double %max_value.2.0259
  %exitcond.not = icmp eq i64 %arg.a.2, %.380
  br i1 %exitcond.not, label %B300.critedge, label %B196.endif, !prof !217

B300.critedge:                                    ; preds = %B196.backedge, %B192
  %max_value.2.0.lcssa = phi double [ %.119.i, %B192 ], [ %max_value.2.0..434, %B196.backedge ]
  store double %max_value.2.0.lcssa, ptr %retptr, align 8
  tail call void @NRT_decref(ptr %arg.a.0)
  br label %common.ret

B58.endif:                                        ; preds = %B0
  %.183 = icmp sgt i64 %arg.a.2, 1
  br i1 %.183, label %end, label %B58.endif.endif.endif, !prof !12

end:                                              ; preds = %B58.endif.endif.endif, %B58.endif
  %.89.0 = phi i64 [ 0, %B58.endif.endif.endif ], [ 1, %B58.endif ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.19.i.i), !noalias !218
  call void @llvm.lifetime.start.p0(ptr nonnull %.23.i.i), !noalias !218
  call void @llvm.lifetime.start.p0(ptr nonnull %.79.i.i), !noalias !218
  %.fca.2.gep.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i, i64 16
  %.fca.3.gep.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i, i64 24
  %.fca.4.gep.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i, i64 32
  store i64 0, ptr %.79.i.i, align 8, !noalias !222
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.19.i.i, i8 0, i64 16, i1 false)
  store i64 1, ptr %.fca.2.gep.i.i, align 8, !noalias !222
  store i64 8, ptr %.fca.3.gep.i.i, align 8, !noalias !222
  store ptr %arg.a.4, ptr %.fca.4.gep.i.i, align 8, !noalias !222
  store i64 1, ptr %.23.i.i, align 8, !noalias !222
  %.81.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i, i64 40
  %.89.i.i = call i32 @numba_attempt_nocopy_reshape(i64 0, ptr nonnull %.81.i.i, ptr nonnull %.81.i.i, i64 1, ptr nonnull %.23.i.i, ptr nonnull %.79.i.i, i64 8, i32 0), !noalias !222
  %.90.i.i = icmp eq i32 %.89.i.i, 0
  br i1 %.90.i.i, label %end.endif.endif.if.if, label %end.endif.endif.endif

B58.endif.endif.endif:                            ; preds = %B58.endif
  br label %end

end.endif.endif.endif:                            ; preds = %end
  %sunkaddr = getelementptr inbounds i8, ptr %.19.i.i, i64 32
  %.101.i.i = load ptr, ptr %sunkaddr, align 8, !noalias !222
  call void @llvm.lifetime.end.p0(ptr nonnull %.19.i.i), !noalias !218
  call void @llvm.lifetime.end.p0(ptr nonnull %.23.i.i), !noalias !218
  call void @llvm.lifetime.end.p0(ptr nonnull %.79.i.i), !noalias !218
  %.119.i = load double, ptr %.101.i.i, align 8, !noalias !218
  %.255.le = fcmp uno double %.119.i, 0.000000e+00
  br i1 %.255.le, label %B188, label %B192

end.endif.endif.if.if:                            ; preds = %end
  call void @llvm.lifetime.end.p0(ptr nonnull %.19.i.i), !noalias !218
  call void @llvm.lifetime.end.p0(ptr nonnull %.23.i.i), !noalias !218
  call void @llvm.lifetime.end.p0(ptr nonnull %.79.i.i), !noalias !218
  store ptr @.const.picklebuf.dc3bba832c4c3758273d0db24b835691af3f316c, ptr %excinfo, align 8
  br label %common.ret

B196.endif:                                       ; preds = %B196.endif.preheader, %B196.backedge
  %max_value.2.0259 = phi double [ %max_value.2.0..434, %B196.backedge ], [ %.119.i, %B196.endif.preheader ]
  %.380254258 = phi i64 [ %.380, %B196.backedge ], [ %.89.0, %B196.endif.preheader ]
  %1 = shl i64 %.380254258, 3
  %scevgep = getelementptr i8, ptr %arg.a.4, i64 %1
  %.434 = load double, ptr %scevgep, align 8
  %.447.le = fcmp uno double %.434, 0.000000e+00
  br i1 %.447.le, label %B262, label %B196.backedge
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.start.p0(ptr captures(none)) #7

declare i32 @numba_attempt_nocopy_reshape(i64, ptr, ptr, i64, ptr, ptr, i64, i32) local_unnamed_addr

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.end.p0(ptr captures(none)) #7

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @expm1(double) local_unnamed_addr #8

define linkonce_odr range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels5scene12march_blocks5_moveB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE54Choice_28int64_2c_20float64_2c_20float64_2c_20int64_29b5TupleI5ArrayIdLi2E1C7mutable7alignedExxEd(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, double %arg.control.0, ptr readnone captures(none) %arg.law.0.0, ptr readnone captures(none) %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr readnone captures(none) %arg.law.1.0, ptr readnone captures(none) %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr readnone captures(none) %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr readnone captures(none) %arg.law.2.0, ptr readnone captures(none) %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr readonly captures(none) %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr readnone captures(none) %arg.blocks.0.0, ptr readnone captures(none) %arg.blocks.0.1, i64 %arg.blocks.0.2, i64 %arg.blocks.0.3, ptr captures(address) %arg.blocks.0.4, i64 %arg.blocks.0.5.0, i64 %arg.blocks.0.5.1, i64 %arg.blocks.0.5.2, i64 %arg.blocks.0.6.0, i64 %arg.blocks.0.6.1, i64 %arg.blocks.0.6.2, ptr readnone captures(none) %arg.blocks.1.0, ptr readnone captures(none) %arg.blocks.1.1, i64 %arg.blocks.1.2, i64 %arg.blocks.1.3, ptr captures(none) %arg.blocks.1.4, i64 %arg.blocks.1.5.0, i64 %arg.blocks.1.6.0, ptr readnone captures(none) %arg.blocks.2.0, ptr readnone captures(none) %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr captures(none) %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0, ptr readnone captures(none) %arg.blocks.3.0.0, ptr readnone captures(none) %arg.blocks.3.0.1, i64 %arg.blocks.3.0.2, i64 %arg.blocks.3.0.3, ptr %arg.blocks.3.0.4, i64 %arg.blocks.3.0.5.0, i64 %arg.blocks.3.0.6.0, ptr readnone captures(none) %arg.blocks.3.1.0, ptr readnone captures(none) %arg.blocks.3.1.1, i64 %arg.blocks.3.1.2, i64 %arg.blocks.3.1.3, ptr readonly captures(none) %arg.blocks.3.1.4, i64 %arg.blocks.3.1.5.0, i64 %arg.blocks.3.1.6.0, ptr readnone captures(none) %arg.blocks.3.2.0, ptr readnone captures(none) %arg.blocks.3.2.1, i64 %arg.blocks.3.2.2, i64 %arg.blocks.3.2.3, ptr readonly captures(none) %arg.blocks.3.2.4, i64 %arg.blocks.3.2.5.0, i64 %arg.blocks.3.2.6.0, ptr readnone captures(none) %arg.blocks.3.3.0, ptr readnone captures(none) %arg.blocks.3.3.1, i64 %arg.blocks.3.3.2, i64 %arg.blocks.3.3.3, ptr %arg.blocks.3.3.4, i64 %arg.blocks.3.3.5.0, i64 %arg.blocks.3.3.6.0, ptr readnone captures(none) %arg.blocks.3.4.0, ptr readnone captures(none) %arg.blocks.3.4.1, i64 %arg.blocks.3.4.2, i64 %arg.blocks.3.4.3, ptr %arg.blocks.3.4.4, i64 %arg.blocks.3.4.5.0, i64 %arg.blocks.3.4.6.0, ptr readnone captures(none) %arg.blocks.3.5.0, ptr readnone captures(none) %arg.blocks.3.5.1, i64 %arg.blocks.3.5.2, i64 %arg.blocks.3.5.3, ptr %arg.blocks.3.5.4, i64 %arg.blocks.3.5.5.0, i64 %arg.blocks.3.5.6.0, ptr readnone captures(none) %arg.p.0, ptr readnone captures(none) %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr readonly captures(none) %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1, ptr readnone captures(none) %arg.older.0, ptr readnone captures(none) %arg.older.1, i64 %arg.older.2, i64 %arg.older.3, ptr captures(none) %arg.older.4, i64 %arg.older.5.0, i64 %arg.older.5.1, i64 %arg.older.6.0, i64 %arg.older.6.1, i64 %arg.step, ptr readnone captures(none) %arg.rows.0.0, ptr readnone captures(none) %arg.rows.0.1, i64 %arg.rows.0.2, i64 %arg.rows.0.3, ptr captures(none) %arg.rows.0.4, i64 %arg.rows.0.5.0, i64 %arg.rows.0.6.0, ptr %arg.rows.1.0.0, ptr readnone captures(none) %arg.rows.1.0.1, i64 %arg.rows.1.0.2, i64 %arg.rows.1.0.3, ptr %arg.rows.1.0.4, i64 %arg.rows.1.0.5.0, i64 %arg.rows.1.0.5.1, i64 %arg.rows.1.0.6.0, i64 %arg.rows.1.0.6.1, ptr %arg.rows.1.1.0, ptr readnone captures(none) %arg.rows.1.1.1, i64 %arg.rows.1.1.2, i64 %arg.rows.1.1.3, ptr captures(none) %arg.rows.1.1.4, i64 %arg.rows.1.1.5.0, i64 %arg.rows.1.1.6.0, ptr %arg.rows.1.2.0, ptr readnone captures(none) %arg.rows.1.2.1, i64 %arg.rows.1.2.2, i64 %arg.rows.1.2.3, ptr captures(none) %arg.rows.1.2.4, i64 %arg.rows.1.2.5.0, i64 %arg.rows.1.2.6.0, ptr readnone captures(none) %arg.rows.2.0, ptr readnone captures(none) %arg.rows.2.1, i64 %arg.rows.2.2, i64 %arg.rows.2.3, ptr captures(address) %arg.rows.2.4, i64 %arg.rows.2.5.0, i64 %arg.rows.2.6.0, ptr readnone captures(none) %arg.lowest.0, ptr readnone captures(none) %arg.lowest.1, i64 %arg.lowest.2, i64 %arg.lowest.3, ptr %arg.lowest.4, i64 %arg.lowest.5.0, i64 %arg.lowest.6.0, i64 %arg.choice.0, double %arg.choice.1, double %arg.choice.2, i64 %arg.choice.3, i8 %arg.every, ptr readnone captures(none) %arg.here.0.0, ptr readnone captures(none) %arg.here.0.1, i64 %arg.here.0.2, i64 %arg.here.0.3, ptr readonly captures(none) %arg.here.0.4, i64 %arg.here.0.5.0, i64 %arg.here.0.5.1, i64 %arg.here.0.6.0, i64 %arg.here.0.6.1, i64 %arg.here.1, i64 %arg.here.2, double %arg.old) local_unnamed_addr {
entry:
  %.19.i.i.i.i3 = alloca { ptr, ptr, i64, i64, ptr, [0 x i64], [0 x i64] }, align 8
  %.23.i.i.i.i4 = alloca [1 x i64], align 8
  %.79.i.i.i.i5 = alloca [1 x i64], align 8
  %.19.i.i.i.i = alloca { ptr, ptr, i64, i64, ptr, [0 x i64], [0 x i64] }, align 8
  %.23.i.i.i.i = alloca [1 x i64], align 8
  %.79.i.i.i.i = alloca [1 x i64], align 8
  %.716 = alloca i64, align 8
  %excinfo.4 = alloca ptr, align 8
  %.777 = alloca { double, i64 }, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.972 = alloca i64, align 8
  store i64 0, ptr %.972, align 8
  %excinfo.7 = alloca ptr, align 8
  %.1014 = alloca { double, i64 }, align 8
  %excinfo.8 = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1014, i8 0, i64 16, i1 false)
  store ptr null, ptr %excinfo.8, align 8
  %.1328 = alloca ptr, align 8
  %excinfo.9 = alloca ptr, align 8
  %.285.1 = ashr i64 %arg.here.0.5.1, 1
  %.323 = add nsw i64 %arg.here.2, %.285.1
  %.359 = icmp slt i64 %arg.here.1, 0
  %.360 = select i1 %.359, i64 %arg.here.0.5.0, i64 0
  %.361 = add i64 %.360, %arg.here.1
  %.372 = icmp slt i64 %arg.here.2, 0
  %.373 = select i1 %.372, i64 %arg.here.0.5.1, i64 0
  %.374 = add i64 %.373, %arg.here.2
  %.377 = icmp slt i64 %.374, 0
  br i1 %.377, label %B0.endif.else.if, label %B0.endif.else.endif, !prof !11

B198:                                             ; preds = %B146.endif, %B0.endif.endif.endif
  %0 = icmp eq i8 %arg.every, 0
  br i1 %0, label %B228, label %B260

B228:                                             ; preds = %B198
  %.22.i.i = icmp eq i64 %arg.lowest.2, 0
  br i1 %.22.i.i, label %B228.if.if, label %B58.endif.endif.i.i

B196.backedge.i.i:                                ; preds = %B196.endif.i.i
  %.327.i.i = add nuw i64 %.327252256.i.i, 1
  %.6.i.inv.i.i = fcmp olt double %.371.i.i, %min_value.2.0257.i.i
  %min_value.2.0..371.i.i = select i1 %.6.i.inv.i.i, double %.371.i.i, double %min_value.2.0257.i.i
  %exitcond.not.i.i = icmp eq i64 %arg.lowest.2, %.327.i.i
  br i1 %exitcond.not.i.i, label %_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE.exit, label %B196.endif.i.i, !prof !217

B58.endif.endif.i.i:                              ; preds = %B228
  %.164.i.i = icmp slt i64 %arg.lowest.2, 2
  br i1 %.164.i.i, label %B58.endif.endif.endif.i.i, label %end.endif.endif.i.i, !prof !11

B58.endif.endif.endif.i.i:                        ; preds = %B58.endif.endif.i.i
  br label %end.endif.endif.i.i

end.endif.endif.i.i:                              ; preds = %B58.endif.endif.endif.i.i, %B58.endif.endif.i.i
  %.83.0.i.i = phi i64 [ 0, %B58.endif.endif.endif.i.i ], [ 1, %B58.endif.endif.i.i ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.19.i.i.i.i3), !noalias !226
  call void @llvm.lifetime.start.p0(ptr nonnull %.23.i.i.i.i4), !noalias !226
  call void @llvm.lifetime.start.p0(ptr nonnull %.79.i.i.i.i5), !noalias !226
  %.fca.2.gep.i.i.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i.i.i3, i64 16
  %.fca.3.gep.i.i.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i.i.i3, i64 24
  %.fca.4.gep.i.i.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i.i.i3, i64 32
  store i64 0, ptr %.79.i.i.i.i5, align 8, !noalias !236
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.19.i.i.i.i3, i8 0, i64 16, i1 false), !noalias !240
  store i64 1, ptr %.fca.2.gep.i.i.i.i, align 8, !noalias !236
  store i64 8, ptr %.fca.3.gep.i.i.i.i, align 8, !noalias !236
  store ptr %arg.lowest.4, ptr %.fca.4.gep.i.i.i.i, align 8, !noalias !236
  store i64 1, ptr %.23.i.i.i.i4, align 8, !noalias !236
  %.81.i.i.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i.i.i3, i64 40
  %.89.i.i.i.i = call i32 @numba_attempt_nocopy_reshape(i64 0, ptr nonnull %.81.i.i.i.i, ptr nonnull %.81.i.i.i.i, i64 1, ptr nonnull %.23.i.i.i.i4, ptr nonnull %.79.i.i.i.i5, i64 8, i32 0), !noalias !236
  %.90.i.i.i.i = icmp eq i32 %.89.i.i.i.i, 0
  br i1 %.90.i.i.i.i, label %end.endif.endif.if.if.i.i, label %for.end.i.i

end.endif.endif.if.if.i.i:                        ; preds = %end.endif.endif.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.19.i.i.i.i3), !noalias !226
  call void @llvm.lifetime.end.p0(ptr nonnull %.23.i.i.i.i4), !noalias !226
  call void @llvm.lifetime.end.p0(ptr nonnull %.79.i.i.i.i5), !noalias !226
  br label %B228.if.if

for.end.i.i:                                      ; preds = %end.endif.endif.i.i
  %1 = icmp slt i64 %arg.lowest.2, 2
  %sunkaddr = getelementptr inbounds i8, ptr %.19.i.i.i.i3, i64 32
  %.101.i.i.i.i = load ptr, ptr %sunkaddr, align 8, !noalias !236
  %.107.i.i.i.i = load ptr, ptr %.19.i.i.i.i3, align 8, !noalias !236
  call void @NRT_incref(ptr %.107.i.i.i.i), !noalias !236
  call void @llvm.lifetime.end.p0(ptr nonnull %.19.i.i.i.i3), !noalias !226
  call void @llvm.lifetime.end.p0(ptr nonnull %.23.i.i.i.i4), !noalias !226
  call void @llvm.lifetime.end.p0(ptr nonnull %.79.i.i.i.i5), !noalias !226
  %.114.i.i.i = load double, ptr %.101.i.i.i.i, align 8, !noalias !226
  %.232.le.i.i = fcmp uno double %.114.i.i.i, 0.000000e+00
  %brmerge.i = or i1 %1, %.232.le.i.i
  br i1 %brmerge.i, label %_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE.exit, label %B196.endif.i.i.preheader, !prof !241

B196.endif.i.i.preheader:                         ; preds = %for.end.i.i
  br label %B196.endif.i.i

B196.endif.i.i:                                   ; preds = %B196.endif.i.i.preheader, %B196.backedge.i.i
  %min_value.2.0257.i.i = phi double [ %min_value.2.0..371.i.i, %B196.backedge.i.i ], [ %.114.i.i.i, %B196.endif.i.i.preheader ]
  %.327252256.i.i = phi i64 [ %.327.i.i, %B196.backedge.i.i ], [ %.83.0.i.i, %B196.endif.i.i.preheader ]
  %2 = shl i64 %.327252256.i.i, 3
  %scevgep.i.i = getelementptr i8, ptr %arg.lowest.4, i64 %2
  %.371.i.i = load double, ptr %scevgep.i.i, align 8, !noalias !240
  %.383.le.i.i = fcmp uno double %.371.i.i, 0.000000e+00
  br i1 %.383.le.i.i, label %_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE.exit, label %B196.backedge.i.i

_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B196.endif.i.i, %B196.backedge.i.i, %for.end.i.i
  %.15.0.ph.i = phi double [ %.114.i.i.i, %for.end.i.i ], [ %min_value.2.0..371.i.i, %B196.backedge.i.i ], [ %.371.i.i, %B196.endif.i.i ]
  %.43.i = fsub double %arg.old, %.15.0.ph.i
  %.44.i = call double @llvm.fabs.f64(double %.43.i)
  %.45.i = fmul double %.44.i, 2.000000e-02
  %.46.i = fsub double %arg.old, %arg.choice.2
  %.47.i = call double @llvm.fabs.f64(double %.46.i)
  %.48.i = fmul double %.47.i, 4.000000e+00
  %.10.i.i = fcmp ogt double %.48.i, %.45.i
  %.11.i.i2 = select i1 %.10.i.i, double %.48.i, double %.45.i
  %.10.i1.i = fcmp ogt double %.15.0.ph.i, %arg.old
  %.11.i2.i = select i1 %.10.i1.i, double %.15.0.ph.i, double %arg.old
  %.10.i3.i = fcmp olt double %.11.i.i2, 1.000000e-09
  %.11.i4.i = select i1 %.10.i3.i, double 1.000000e-09, double %.11.i.i2
  %.133.i = fadd double %.11.i2.i, %.11.i4.i
  br label %B260

B260:                                             ; preds = %_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE.exit, %B198
  %"$phi260.1.2.0" = phi double [ 0x7FF0000000000000, %B198 ], [ %.133.i, %_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE.exit ]
  store i64 0, ptr %.716, align 8
  %.726 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks13choose_blocksB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIxLi1E1C7mutable7alignedE(ptr nonnull %.716, ptr nonnull %excinfo.4, ptr %arg.rows.0.0, ptr %arg.rows.0.1, i64 %arg.rows.0.2, i64 %arg.rows.0.3, ptr %arg.rows.0.4, i64 %arg.rows.0.5.0, i64 %arg.rows.0.6.0, ptr %arg.lowest.0, ptr %arg.lowest.1, i64 %arg.lowest.2, i64 %arg.lowest.3, ptr %arg.lowest.4, i64 %arg.lowest.5.0, i64 %arg.lowest.6.0, i64 %arg.here.2, i64 %.285.1, double %"$phi260.1.2.0", ptr %arg.blocks.2.0, ptr %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0)
  %.736 = load i64, ptr %.716, align 8
  %cond = icmp eq i32 %.726, 0
  br i1 %cond, label %B328, label %B260.if.if, !prof !0

B328:                                             ; preds = %B146.endif, %B260
  %at.2.1 = phi i64 [ %arg.choice.0, %B146.endif ], [ %arg.here.2, %B260 ]
  %cap.3.1 = phi double [ %arg.choice.1, %B146.endif ], [ %"$phi260.1.2.0", %B260 ]
  %chosen.2.1 = phi double [ %arg.choice.2, %B146.endif ], [ %arg.old, %B260 ]
  %count.3.1 = phi i64 [ %arg.choice.3, %B146.endif ], [ %.736, %B260 ]
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.777, i8 0, i64 16, i1 false)
  %.832 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks14balance_blocksB3v40B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedExx213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEd(ptr nonnull %.777, ptr nonnull %excinfo.5, double %arg.control.0, ptr %arg.law.0.0, ptr %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr %arg.law.1.0, ptr %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr %arg.law.2.0, ptr %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr %arg.blocks.0.0, ptr %arg.blocks.0.1, i64 %arg.blocks.0.2, i64 %arg.blocks.0.3, ptr %arg.blocks.0.4, i64 %arg.blocks.0.5.0, i64 %arg.blocks.0.5.1, i64 %arg.blocks.0.5.2, i64 %arg.blocks.0.6.0, i64 %arg.blocks.0.6.1, i64 %arg.blocks.0.6.2, ptr %arg.blocks.1.0, ptr %arg.blocks.1.1, i64 %arg.blocks.1.2, i64 %arg.blocks.1.3, ptr %arg.blocks.1.4, i64 %arg.blocks.1.5.0, i64 %arg.blocks.1.6.0, ptr %arg.blocks.2.0, ptr %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0, ptr %arg.blocks.3.0.0, ptr %arg.blocks.3.0.1, i64 %arg.blocks.3.0.2, i64 %arg.blocks.3.0.3, ptr %arg.blocks.3.0.4, i64 %arg.blocks.3.0.5.0, i64 %arg.blocks.3.0.6.0, ptr %arg.blocks.3.1.0, ptr %arg.blocks.3.1.1, i64 %arg.blocks.3.1.2, i64 %arg.blocks.3.1.3, ptr %arg.blocks.3.1.4, i64 %arg.blocks.3.1.5.0, i64 %arg.blocks.3.1.6.0, ptr %arg.blocks.3.2.0, ptr %arg.blocks.3.2.1, i64 %arg.blocks.3.2.2, i64 %arg.blocks.3.2.3, ptr %arg.blocks.3.2.4, i64 %arg.blocks.3.2.5.0, i64 %arg.blocks.3.2.6.0, ptr %arg.blocks.3.3.0, ptr %arg.blocks.3.3.1, i64 %arg.blocks.3.3.2, i64 %arg.blocks.3.3.3, ptr %arg.blocks.3.3.4, i64 %arg.blocks.3.3.5.0, i64 %arg.blocks.3.3.6.0, ptr %arg.blocks.3.4.0, ptr %arg.blocks.3.4.1, i64 %arg.blocks.3.4.2, i64 %arg.blocks.3.4.3, ptr %arg.blocks.3.4.4, i64 %arg.blocks.3.4.5.0, i64 %arg.blocks.3.4.6.0, ptr %arg.blocks.3.5.0, ptr %arg.blocks.3.5.1, i64 %arg.blocks.3.5.2, i64 %arg.blocks.3.5.3, ptr %arg.blocks.3.5.4, i64 %arg.blocks.3.5.5.0, i64 %arg.blocks.3.5.6.0, ptr %arg.p.0, ptr %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1, ptr %arg.older.0, ptr %arg.older.1, i64 %arg.older.2, i64 %arg.older.3, ptr %arg.older.4, i64 %arg.older.5.0, i64 %arg.older.5.1, i64 %arg.older.6.0, i64 %arg.older.6.1, i64 %arg.step, i64 %count.3.1, ptr %arg.rows.0.0, ptr %arg.rows.0.1, i64 %arg.rows.0.2, i64 %arg.rows.0.3, ptr %arg.rows.0.4, i64 %arg.rows.0.5.0, i64 %arg.rows.0.6.0, ptr %arg.rows.1.0.0, ptr %arg.rows.1.0.1, i64 %arg.rows.1.0.2, i64 %arg.rows.1.0.3, ptr %arg.rows.1.0.4, i64 %arg.rows.1.0.5.0, i64 %arg.rows.1.0.5.1, i64 %arg.rows.1.0.6.0, i64 %arg.rows.1.0.6.1, ptr %arg.rows.1.1.0, ptr %arg.rows.1.1.1, i64 %arg.rows.1.1.2, i64 %arg.rows.1.1.3, ptr %arg.rows.1.1.4, i64 %arg.rows.1.1.5.0, i64 %arg.rows.1.1.6.0, ptr %arg.rows.1.2.0, ptr %arg.rows.1.2.1, i64 %arg.rows.1.2.2, i64 %arg.rows.1.2.3, ptr %arg.rows.1.2.4, i64 %arg.rows.1.2.5.0, i64 %arg.rows.1.2.6.0, ptr %arg.rows.2.0, ptr %arg.rows.2.1, i64 %arg.rows.2.2, i64 %arg.rows.2.3, ptr %arg.rows.2.4, i64 %arg.rows.2.5.0, i64 %arg.rows.2.6.0, ptr %arg.here.0.0, ptr %arg.here.0.1, i64 %.459, i64 %arg.here.0.3, ptr %.483, i64 %.459, i64 %arg.here.0.6.1, double %arg.old)
  %cond65 = icmp eq i32 %.832, 0
  br i1 %cond65, label %B328.endif, label %B328.if.if, !prof !0

B426:                                             ; preds = %B426.preheader55, %B426.endif.endif.endif
  %.933 = phi double [ %.1128, %B426.endif.endif.endif ], [ %.895, %B426.preheader55 ]
  %3 = icmp slt i64 %arg.lowest.2, 2
  br i1 %3, label %B58.endif.endif.endif.i.i53, label %end.endif.endif.i.i9, !prof !11

B196.backedge.i.i29:                              ; preds = %B196.endif.i.i23
  %.327.i.i30 = add nuw i64 %.327252256.i.i25, 1
  %.6.i.inv.i.i31 = fcmp olt double %.371.i.i27, %min_value.2.0257.i.i24
  %min_value.2.0..371.i.i32 = select i1 %.6.i.inv.i.i31, double %.371.i.i27, double %min_value.2.0257.i.i24
  %exitcond.not.i.i33 = icmp eq i64 %arg.lowest.2, %.327.i.i30
  br i1 %exitcond.not.i.i33, label %B426.endif, label %B196.endif.i.i23, !prof !217

B58.endif.endif.endif.i.i53:                      ; preds = %B426
  br label %end.endif.endif.i.i9

end.endif.endif.i.i9:                             ; preds = %B58.endif.endif.endif.i.i53, %B426
  %.83.0.i.i10 = phi i64 [ 0, %B58.endif.endif.endif.i.i53 ], [ 1, %B426 ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.19.i.i.i.i3), !noalias !242
  call void @llvm.lifetime.start.p0(ptr nonnull %.23.i.i.i.i4), !noalias !242
  call void @llvm.lifetime.start.p0(ptr nonnull %.79.i.i.i.i5), !noalias !242
  store i64 0, ptr %.79.i.i.i.i5, align 8, !noalias !252
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.19.i.i.i.i3, i8 0, i64 16, i1 false), !noalias !256
  %sunkaddr124 = getelementptr inbounds i8, ptr %.19.i.i.i.i3, i64 16
  store i64 1, ptr %sunkaddr124, align 8, !noalias !252
  %sunkaddr125 = getelementptr inbounds i8, ptr %.19.i.i.i.i3, i64 24
  store i64 8, ptr %sunkaddr125, align 8, !noalias !252
  %sunkaddr126 = getelementptr inbounds i8, ptr %.19.i.i.i.i3, i64 32
  store ptr %arg.lowest.4, ptr %sunkaddr126, align 8, !noalias !252
  store i64 1, ptr %.23.i.i.i.i4, align 8, !noalias !252
  %.89.i.i.i.i15 = call i32 @numba_attempt_nocopy_reshape(i64 0, ptr nonnull %.81.i.i.i.i14, ptr nonnull %.81.i.i.i.i14, i64 1, ptr nonnull %.23.i.i.i.i4, ptr nonnull %.79.i.i.i.i5, i64 8, i32 0), !noalias !252
  %.90.i.i.i.i16 = icmp eq i32 %.89.i.i.i.i15, 0
  br i1 %.90.i.i.i.i16, label %end.endif.endif.if.if.i.i50, label %for.end.i.i17

end.endif.endif.if.if.i.i50:                      ; preds = %end.endif.endif.i.i9
  call void @llvm.lifetime.end.p0(ptr nonnull %.19.i.i.i.i3), !noalias !242
  call void @llvm.lifetime.end.p0(ptr nonnull %.23.i.i.i.i4), !noalias !242
  call void @llvm.lifetime.end.p0(ptr nonnull %.79.i.i.i.i5), !noalias !242
  br label %B426.if.if

for.end.i.i17:                                    ; preds = %end.endif.endif.i.i9
  %4 = icmp slt i64 %arg.lowest.2, 2
  %sunkaddr127 = getelementptr inbounds i8, ptr %.19.i.i.i.i3, i64 32
  %.101.i.i.i.i18 = load ptr, ptr %sunkaddr127, align 8, !noalias !252
  %.107.i.i.i.i19 = load ptr, ptr %.19.i.i.i.i3, align 8, !noalias !252
  call void @NRT_incref(ptr %.107.i.i.i.i19), !noalias !252
  call void @llvm.lifetime.end.p0(ptr nonnull %.19.i.i.i.i3), !noalias !242
  call void @llvm.lifetime.end.p0(ptr nonnull %.23.i.i.i.i4), !noalias !242
  call void @llvm.lifetime.end.p0(ptr nonnull %.79.i.i.i.i5), !noalias !242
  %.114.i.i.i20 = load double, ptr %.101.i.i.i.i18, align 8, !noalias !242
  %.232.le.i.i21 = fcmp uno double %.114.i.i.i20, 0.000000e+00
  %brmerge.i22 = or i1 %4, %.232.le.i.i21
  br i1 %brmerge.i22, label %B426.endif, label %B196.endif.i.i23.preheader, !prof !241

B196.endif.i.i23.preheader:                       ; preds = %for.end.i.i17
  br label %B196.endif.i.i23

B196.endif.i.i23:                                 ; preds = %B196.endif.i.i23.preheader, %B196.backedge.i.i29
  %min_value.2.0257.i.i24 = phi double [ %min_value.2.0..371.i.i32, %B196.backedge.i.i29 ], [ %.114.i.i.i20, %B196.endif.i.i23.preheader ]
  %.327252256.i.i25 = phi i64 [ %.327.i.i30, %B196.backedge.i.i29 ], [ %.83.0.i.i10, %B196.endif.i.i23.preheader ]
  %5 = shl i64 %.327252256.i.i25, 3
  %scevgep.i.i26 = getelementptr i8, ptr %arg.lowest.4, i64 %5
  %.371.i.i27 = load double, ptr %scevgep.i.i26, align 8, !noalias !256
  %.383.le.i.i28 = fcmp uno double %.371.i.i27, 0.000000e+00
  br i1 %.383.le.i.i28, label %B426.endif, label %B196.backedge.i.i29

B0.endif.endif:                                   ; preds = %B0.endif.else.endif.endif.endif.if, %B0.endif.else.endif.endif.endif
  %.362.sroa.13.0 = phi i64 [ %.362.sroa.13.1, %B0.endif.else.endif.endif.endif ], [ %arg.here.0.5.1, %B0.endif.else.endif.endif.endif.if ]
  %.450 = sub i64 %.362.sroa.13.0, %.362.sroa.0.3
  %.459 = tail call i64 @llvm.smax.i64(i64 %.450, i64 0)
  %.479 = mul i64 %.361, %arg.here.0.5.1
  %6 = getelementptr double, ptr %arg.here.0.4, i64 %.479
  %.483 = getelementptr double, ptr %6, i64 %.362.sroa.0.3
  %.181212.not.i = icmp slt i64 %arg.law.0.2, 1
  br i1 %.181212.not.i, label %B0.endif.endif.endif, label %iter.check.i

iter.check.i:                                     ; preds = %B0.endif.endif
  %min.iters.check.i = icmp samesign ult i64 %arg.law.0.2, 4
  br i1 %min.iters.check.i, label %B56.preheader.i, label %vector.memcheck.i

vector.memcheck.i:                                ; preds = %iter.check.i
  %7 = ptrtoint ptr %arg.blocks.3.5.4 to i64
  %8 = ptrtoint ptr %arg.law.0.4 to i64
  %9 = ptrtoint ptr %arg.blocks.3.0.4 to i64
  %10 = sub i64 %7, %8
  %diff.check.i = icmp ult i64 %10, 256
  %11 = sub i64 %7, %9
  %diff.check4.i = icmp ult i64 %11, 256
  %conflict.rdx.i = or i1 %diff.check.i, %diff.check4.i
  br i1 %conflict.rdx.i, label %B56.preheader.i, label %vector.main.loop.iter.check.i

vector.main.loop.iter.check.i:                    ; preds = %vector.memcheck.i
  %const = bitcast i64 9223372036854775776 to i64
  %min.iters.check5.i = icmp samesign ult i64 %arg.law.0.2, 32
  br i1 %min.iters.check5.i, label %vec.epilog.ph.i, label %vector.ph.i

vector.ph.i:                                      ; preds = %vector.main.loop.iter.check.i
  %n.vec.i = and i64 %arg.law.0.2, %const
  br label %vector.body.i

vector.body.i:                                    ; preds = %vector.body.i, %vector.ph.i
  %index.i = phi i64 [ 0, %vector.ph.i ], [ %index.next.i, %vector.body.i ]
  %sunkaddr128 = mul i64 %index.i, 8
  %sunkaddr129 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr128
  %wide.load.i = load <8 x double>, ptr %sunkaddr129, align 8, !noalias !257
  %sunkaddr130 = mul i64 %index.i, 8
  %sunkaddr131 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr130
  %sunkaddr132 = getelementptr i8, ptr %sunkaddr131, i64 64
  %wide.load6.i = load <8 x double>, ptr %sunkaddr132, align 8, !noalias !257
  %sunkaddr133 = mul i64 %index.i, 8
  %sunkaddr134 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr133
  %sunkaddr135 = getelementptr i8, ptr %sunkaddr134, i64 128
  %wide.load7.i = load <8 x double>, ptr %sunkaddr135, align 8, !noalias !257
  %sunkaddr136 = mul i64 %index.i, 8
  %sunkaddr137 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr136
  %sunkaddr138 = getelementptr i8, ptr %sunkaddr137, i64 192
  %wide.load8.i = load <8 x double>, ptr %sunkaddr138, align 8, !noalias !257
  %sunkaddr139 = mul i64 %index.i, 8
  %sunkaddr140 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr139
  %wide.load9.i = load <8 x double>, ptr %sunkaddr140, align 8, !noalias !257
  %sunkaddr141 = mul i64 %index.i, 8
  %sunkaddr142 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr141
  %sunkaddr143 = getelementptr i8, ptr %sunkaddr142, i64 64
  %wide.load10.i = load <8 x double>, ptr %sunkaddr143, align 8, !noalias !257
  %sunkaddr144 = mul i64 %index.i, 8
  %sunkaddr145 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr144
  %sunkaddr146 = getelementptr i8, ptr %sunkaddr145, i64 128
  %wide.load11.i = load <8 x double>, ptr %sunkaddr146, align 8, !noalias !257
  %sunkaddr147 = mul i64 %index.i, 8
  %sunkaddr148 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr147
  %sunkaddr149 = getelementptr i8, ptr %sunkaddr148, i64 192
  %wide.load12.i = load <8 x double>, ptr %sunkaddr149, align 8, !noalias !257
  %12 = fmul <8 x double> %wide.load.i, %wide.load9.i
  %13 = fmul <8 x double> %wide.load6.i, %wide.load10.i
  %14 = fmul <8 x double> %wide.load7.i, %wide.load11.i
  %15 = fmul <8 x double> %wide.load8.i, %wide.load12.i
  %sunkaddr150 = mul i64 %index.i, 8
  %sunkaddr151 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr150
  store <8 x double> %12, ptr %sunkaddr151, align 8, !noalias !257
  %sunkaddr152 = mul i64 %index.i, 8
  %sunkaddr153 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr152
  %sunkaddr154 = getelementptr i8, ptr %sunkaddr153, i64 64
  store <8 x double> %13, ptr %sunkaddr154, align 8, !noalias !257
  %sunkaddr155 = mul i64 %index.i, 8
  %sunkaddr156 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr155
  %sunkaddr157 = getelementptr i8, ptr %sunkaddr156, i64 128
  store <8 x double> %14, ptr %sunkaddr157, align 8, !noalias !257
  %sunkaddr158 = mul i64 %index.i, 8
  %sunkaddr159 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr158
  %sunkaddr160 = getelementptr i8, ptr %sunkaddr159, i64 192
  store <8 x double> %15, ptr %sunkaddr160, align 8, !noalias !257
  %index.next.i = add nuw nsw i64 %index.i, 32
  %16 = icmp eq i64 %n.vec.i, %index.next.i
  br i1 %16, label %middle.block.i, label %vector.body.i, !llvm.loop !260

middle.block.i:                                   ; preds = %vector.body.i
  %cmp.n.i = icmp eq i64 %arg.law.0.2, %n.vec.i
  br i1 %cmp.n.i, label %B0.endif.endif.endif, label %vec.epilog.iter.check.i

vec.epilog.iter.check.i:                          ; preds = %middle.block.i
  %n.mod.vf.i = and i64 %arg.law.0.2, 28
  %min.epilog.iters.check.i = icmp eq i64 %n.mod.vf.i, 0
  br i1 %min.epilog.iters.check.i, label %B56.preheader.i, label %vec.epilog.ph.i, !prof !91

vec.epilog.ph.i:                                  ; preds = %vec.epilog.iter.check.i, %vector.main.loop.iter.check.i
  %vec.epilog.resume.val.i = phi i64 [ %n.vec.i, %vec.epilog.iter.check.i ], [ 0, %vector.main.loop.iter.check.i ]
  %const_mat = add i64 %const, 28
  %n.vec14.i = and i64 %arg.law.0.2, %const_mat
  br label %vec.epilog.vector.body.i

vec.epilog.vector.body.i:                         ; preds = %vec.epilog.vector.body.i, %vec.epilog.ph.i
  %index15.i = phi i64 [ %vec.epilog.resume.val.i, %vec.epilog.ph.i ], [ %index.next18.i, %vec.epilog.vector.body.i ]
  %17 = shl i64 %index15.i, 3
  %scevgep108 = getelementptr i8, ptr %arg.law.0.4, i64 %17
  %wide.load16.i = load <4 x double>, ptr %scevgep108, align 8, !noalias !257
  %18 = shl i64 %index15.i, 3
  %scevgep107 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %18
  %wide.load17.i = load <4 x double>, ptr %scevgep107, align 8, !noalias !257
  %19 = fmul <4 x double> %wide.load16.i, %wide.load17.i
  %20 = shl i64 %index15.i, 3
  %scevgep106 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %20
  store <4 x double> %19, ptr %scevgep106, align 8, !noalias !257
  %index.next18.i = add nuw i64 %index15.i, 4
  %21 = icmp eq i64 %n.vec14.i, %index.next18.i
  br i1 %21, label %vec.epilog.middle.block.i, label %vec.epilog.vector.body.i, !llvm.loop !261

vec.epilog.middle.block.i:                        ; preds = %vec.epilog.vector.body.i
  %cmp.n19.i = icmp eq i64 %arg.law.0.2, %n.vec14.i
  br i1 %cmp.n19.i, label %B0.endif.endif.endif, label %B56.preheader.i

B56.preheader.i:                                  ; preds = %vec.epilog.middle.block.i, %vec.epilog.iter.check.i, %vector.memcheck.i, %iter.check.i
  %.187211213.ph.i = phi i64 [ 0, %iter.check.i ], [ 0, %vector.memcheck.i ], [ %n.vec.i, %vec.epilog.iter.check.i ], [ %n.vec14.i, %vec.epilog.middle.block.i ]
  %22 = sub nsw i64 %arg.law.0.2, %.187211213.ph.i
  %xtraiter.i = and i64 %22, 7
  %lcmp.mod.not.i = icmp eq i64 %xtraiter.i, 0
  br i1 %lcmp.mod.not.i, label %B56.prol.loopexit.i, label %B56.prol.i.preheader

B56.prol.i.preheader:                             ; preds = %B56.preheader.i
  br label %B56.prol.i

B56.prol.i:                                       ; preds = %B56.prol.i.preheader, %B56.prol.i
  %lsr.iv = phi i64 [ %xtraiter.i, %B56.prol.i.preheader ], [ %lsr.iv.next, %B56.prol.i ]
  %.187211213.prol.i = phi i64 [ %.194.prol.i, %B56.prol.i ], [ %.187211213.ph.i, %B56.prol.i.preheader ]
  %.194.prol.i = add nuw i64 %.187211213.prol.i, 1
  %23 = shl i64 %.187211213.prol.i, 3
  %scevgep105 = getelementptr i8, ptr %arg.law.0.4, i64 %23
  %.249.prol.i = load double, ptr %scevgep105, align 8, !noalias !257
  %24 = shl i64 %.187211213.prol.i, 3
  %scevgep104 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %24
  %.280.prol.i = load double, ptr %scevgep104, align 8, !noalias !257
  %.281.prol.i = fmul double %.249.prol.i, %.280.prol.i
  %25 = shl i64 %.187211213.prol.i, 3
  %scevgep103 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %25
  store double %.281.prol.i, ptr %scevgep103, align 8, !noalias !257
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %prol.iter.cmp.not.i = icmp eq i64 %lsr.iv.next, 0
  br i1 %prol.iter.cmp.not.i, label %B56.prol.loopexit.i, label %B56.prol.i, !llvm.loop !262

B56.prol.loopexit.i:                              ; preds = %B56.prol.i, %B56.preheader.i
  %.187211213.unr.i = phi i64 [ %.187211213.ph.i, %B56.preheader.i ], [ %.194.prol.i, %B56.prol.i ]
  %26 = sub nsw i64 %.187211213.ph.i, %arg.law.0.2
  %27 = icmp ugt i64 %26, -8
  br i1 %27, label %B0.endif.endif.endif, label %B56.i.preheader

B56.i.preheader:                                  ; preds = %B56.prol.loopexit.i
  br label %B56.i

B56.i:                                            ; preds = %B56.i.preheader, %B56.i
  %.187211213.i = phi i64 [ %.194.7.i, %B56.i ], [ %.187211213.unr.i, %B56.i.preheader ]
  %sunkaddr161 = mul i64 %.187211213.i, 8
  %sunkaddr162 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr161
  %.249.i = load double, ptr %sunkaddr162, align 8, !noalias !257
  %sunkaddr163 = mul i64 %.187211213.i, 8
  %sunkaddr164 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr163
  %.280.i = load double, ptr %sunkaddr164, align 8, !noalias !257
  %.281.i = fmul double %.249.i, %.280.i
  %sunkaddr165 = mul i64 %.187211213.i, 8
  %sunkaddr166 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr165
  store double %.281.i, ptr %sunkaddr166, align 8, !noalias !257
  %sunkaddr167 = mul i64 %.187211213.i, 8
  %sunkaddr168 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr167
  %sunkaddr169 = getelementptr i8, ptr %sunkaddr168, i64 8
  %.249.1.i = load double, ptr %sunkaddr169, align 8, !noalias !257
  %sunkaddr170 = mul i64 %.187211213.i, 8
  %sunkaddr171 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr170
  %sunkaddr172 = getelementptr i8, ptr %sunkaddr171, i64 8
  %.280.1.i = load double, ptr %sunkaddr172, align 8, !noalias !257
  %.281.1.i = fmul double %.249.1.i, %.280.1.i
  %sunkaddr173 = mul i64 %.187211213.i, 8
  %sunkaddr174 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr173
  %sunkaddr175 = getelementptr i8, ptr %sunkaddr174, i64 8
  store double %.281.1.i, ptr %sunkaddr175, align 8, !noalias !257
  %sunkaddr176 = mul i64 %.187211213.i, 8
  %sunkaddr177 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr176
  %sunkaddr178 = getelementptr i8, ptr %sunkaddr177, i64 16
  %.249.2.i = load double, ptr %sunkaddr178, align 8, !noalias !257
  %sunkaddr179 = mul i64 %.187211213.i, 8
  %sunkaddr180 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr179
  %sunkaddr181 = getelementptr i8, ptr %sunkaddr180, i64 16
  %.280.2.i = load double, ptr %sunkaddr181, align 8, !noalias !257
  %.281.2.i = fmul double %.249.2.i, %.280.2.i
  %sunkaddr182 = mul i64 %.187211213.i, 8
  %sunkaddr183 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr182
  %sunkaddr184 = getelementptr i8, ptr %sunkaddr183, i64 16
  store double %.281.2.i, ptr %sunkaddr184, align 8, !noalias !257
  %sunkaddr185 = mul i64 %.187211213.i, 8
  %sunkaddr186 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr185
  %sunkaddr187 = getelementptr i8, ptr %sunkaddr186, i64 24
  %.249.3.i = load double, ptr %sunkaddr187, align 8, !noalias !257
  %sunkaddr188 = mul i64 %.187211213.i, 8
  %sunkaddr189 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr188
  %sunkaddr190 = getelementptr i8, ptr %sunkaddr189, i64 24
  %.280.3.i = load double, ptr %sunkaddr190, align 8, !noalias !257
  %.281.3.i = fmul double %.249.3.i, %.280.3.i
  %sunkaddr191 = mul i64 %.187211213.i, 8
  %sunkaddr192 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr191
  %sunkaddr193 = getelementptr i8, ptr %sunkaddr192, i64 24
  store double %.281.3.i, ptr %sunkaddr193, align 8, !noalias !257
  %sunkaddr194 = mul i64 %.187211213.i, 8
  %sunkaddr195 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr194
  %sunkaddr196 = getelementptr i8, ptr %sunkaddr195, i64 32
  %.249.4.i = load double, ptr %sunkaddr196, align 8, !noalias !257
  %sunkaddr197 = mul i64 %.187211213.i, 8
  %sunkaddr198 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr197
  %sunkaddr199 = getelementptr i8, ptr %sunkaddr198, i64 32
  %.280.4.i = load double, ptr %sunkaddr199, align 8, !noalias !257
  %.281.4.i = fmul double %.249.4.i, %.280.4.i
  %sunkaddr200 = mul i64 %.187211213.i, 8
  %sunkaddr201 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr200
  %sunkaddr202 = getelementptr i8, ptr %sunkaddr201, i64 32
  store double %.281.4.i, ptr %sunkaddr202, align 8, !noalias !257
  %sunkaddr203 = mul i64 %.187211213.i, 8
  %sunkaddr204 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr203
  %sunkaddr205 = getelementptr i8, ptr %sunkaddr204, i64 40
  %.249.5.i = load double, ptr %sunkaddr205, align 8, !noalias !257
  %sunkaddr206 = mul i64 %.187211213.i, 8
  %sunkaddr207 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr206
  %sunkaddr208 = getelementptr i8, ptr %sunkaddr207, i64 40
  %.280.5.i = load double, ptr %sunkaddr208, align 8, !noalias !257
  %.281.5.i = fmul double %.249.5.i, %.280.5.i
  %sunkaddr209 = mul i64 %.187211213.i, 8
  %sunkaddr210 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr209
  %sunkaddr211 = getelementptr i8, ptr %sunkaddr210, i64 40
  store double %.281.5.i, ptr %sunkaddr211, align 8, !noalias !257
  %sunkaddr212 = mul i64 %.187211213.i, 8
  %sunkaddr213 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr212
  %sunkaddr214 = getelementptr i8, ptr %sunkaddr213, i64 48
  %.249.6.i = load double, ptr %sunkaddr214, align 8, !noalias !257
  %sunkaddr215 = mul i64 %.187211213.i, 8
  %sunkaddr216 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr215
  %sunkaddr217 = getelementptr i8, ptr %sunkaddr216, i64 48
  %.280.6.i = load double, ptr %sunkaddr217, align 8, !noalias !257
  %.281.6.i = fmul double %.249.6.i, %.280.6.i
  %sunkaddr218 = mul i64 %.187211213.i, 8
  %sunkaddr219 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr218
  %sunkaddr220 = getelementptr i8, ptr %sunkaddr219, i64 48
  store double %.281.6.i, ptr %sunkaddr220, align 8, !noalias !257
  %.194.7.i = add nuw nsw i64 %.187211213.i, 8
  %sunkaddr221 = mul i64 %.187211213.i, 8
  %sunkaddr222 = getelementptr i8, ptr %arg.law.0.4, i64 %sunkaddr221
  %sunkaddr223 = getelementptr i8, ptr %sunkaddr222, i64 56
  %.249.7.i = load double, ptr %sunkaddr223, align 8, !noalias !257
  %sunkaddr224 = mul i64 %.187211213.i, 8
  %sunkaddr225 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr224
  %sunkaddr226 = getelementptr i8, ptr %sunkaddr225, i64 56
  %.280.7.i = load double, ptr %sunkaddr226, align 8, !noalias !257
  %.281.7.i = fmul double %.249.7.i, %.280.7.i
  %sunkaddr227 = mul i64 %.187211213.i, 8
  %sunkaddr228 = getelementptr i8, ptr %arg.blocks.3.5.4, i64 %sunkaddr227
  %sunkaddr229 = getelementptr i8, ptr %sunkaddr228, i64 56
  store double %.281.7.i, ptr %sunkaddr229, align 8, !noalias !257
  %exitcond.not.7.i = icmp eq i64 %arg.law.0.2, %.194.7.i
  br i1 %exitcond.not.7.i, label %B0.endif.endif.endif, label %B56.i, !llvm.loop !263

B0.endif.else.if:                                 ; preds = %entry
  br label %B0.endif.else.endif

B0.endif.else.endif:                              ; preds = %B0.endif.else.if, %entry
  %.362.sroa.0.1 = phi i64 [ 0, %B0.endif.else.if ], [ %.374, %entry ]
  %.382.not = icmp slt i64 %.374, %arg.here.0.5.1
  br i1 %.382.not, label %B0.endif.else.endif.endif, label %B0.endif.else.endif.if, !prof !12

B0.endif.else.endif.if:                           ; preds = %B0.endif.else.endif
  br label %B0.endif.else.endif.endif

B0.endif.else.endif.endif:                        ; preds = %B0.endif.else.endif.if, %B0.endif.else.endif
  %.362.sroa.0.3 = phi i64 [ %arg.here.0.5.1, %B0.endif.else.endif.if ], [ %.362.sroa.0.1, %B0.endif.else.endif ]
  %.389 = icmp slt i64 %.323, 0
  %.390 = select i1 %.389, i64 %arg.here.0.5.1, i64 0
  %.391 = add i64 %.390, %.323
  %.394 = icmp slt i64 %.391, 0
  br i1 %.394, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !11

B0.endif.else.endif.endif.if:                     ; preds = %B0.endif.else.endif.endif
  br label %B0.endif.else.endif.endif.endif

B0.endif.else.endif.endif.endif:                  ; preds = %B0.endif.else.endif.endif.if, %B0.endif.else.endif.endif
  %.362.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.391, %B0.endif.else.endif.endif ]
  %.399.not = icmp slt i64 %.391, %arg.here.0.5.1
  br i1 %.399.not, label %B0.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !12

B0.endif.else.endif.endif.endif.if:               ; preds = %B0.endif.else.endif.endif.endif
  br label %B0.endif.endif

B0.endif.endif.endif:                             ; preds = %B56.i, %B56.prol.loopexit.i, %vec.epilog.middle.block.i, %middle.block.i, %B0.endif.endif
  %.580 = icmp slt i64 %arg.choice.0, 0
  br i1 %.580, label %B198, label %B146.endif

common.ret:                                       ; preds = %B650.endif.if.if, %B650.endif.endif, %B426.endif.endif.if.if, %B426.endif.if.if, %B426.if.if, %B328.if.if, %B260.if.if, %B228.if.if
  %common.ret.op = phi i32 [ %.1350, %B650.endif.if.if ], [ 0, %B650.endif.endif ], [ 1, %B228.if.if ], [ %.726, %B260.if.if ], [ %.832, %B328.if.if ], [ 1, %B426.if.if ], [ %.982, %B426.endif.if.if ], [ %.1069, %B426.endif.endif.if.if ]
  ret i32 %common.ret.op

B146.endif:                                       ; preds = %B0.endif.endif.endif
  %.7.i = sub nsw i64 %arg.here.2, %arg.choice.0
  %.10.i = tail call i64 @llvm.abs.i64(i64 %.7.i, i1 false)
  %.11.i = sub nsw i64 %.285.1, %.10.i
  %.11.i.i = tail call i64 @llvm.smin.i64(i64 %.11.i, i64 %.10.i)
  %.632 = icmp sgt i64 %.11.i.i, 16
  br i1 %.632, label %B198, label %B328

B228.if.if:                                       ; preds = %end.endif.endif.if.if.i.i, %B228
  %excinfo.3.0.ph = phi ptr [ @.const.picklebuf.dc3bba832c4c3758273d0db24b835691af3f316c.28, %end.endif.endif.if.if.i.i ], [ @.const.picklebuf.917b4fd376f3111025427fa1537059f6520d9ca7, %B228 ]
  store ptr %excinfo.3.0.ph, ptr %excinfo, align 8
  br label %common.ret

B260.if.if:                                       ; preds = %B260
  store ptr null, ptr %excinfo, align 8
  br label %common.ret

B328.endif:                                       ; preds = %B328
  %sunkaddr230 = getelementptr inbounds i8, ptr %.777, i64 8
  %.842.fca.1.load = load i64, ptr %sunkaddr230, align 8
  %.895 = load double, ptr %arg.rows.1.1.4, align 8
  %.897 = fcmp ogt double %.895, %cap.3.1
  br i1 %.897, label %B426.preheader, label %B650.else

B426.preheader:                                   ; preds = %B328.endif
  %.22.i.i6 = icmp eq i64 %arg.lowest.2, 0
  %.81.i.i.i.i14 = getelementptr inbounds nuw i8, ptr %.19.i.i.i.i3, i64 40
  br i1 %.22.i.i6, label %B426.if.if, label %B426.preheader55

B426.preheader55:                                 ; preds = %B426.preheader
  br label %B426

B328.if.if:                                       ; preds = %B328
  %.840 = icmp sgt i32 %.832, 0
  %.833 = load ptr, ptr %excinfo.5, align 8
  %.841 = select i1 %.840, ptr %.833, ptr undef
  store ptr %.841, ptr %excinfo, align 8
  br label %common.ret

B426.endif:                                       ; preds = %B196.endif.i.i23, %B196.backedge.i.i29, %for.end.i.i17
  %.15.0.ph.i35 = phi double [ %.114.i.i.i20, %for.end.i.i17 ], [ %min_value.2.0..371.i.i32, %B196.backedge.i.i29 ], [ %.371.i.i27, %B196.endif.i.i23 ]
  %.43.i36 = fsub double %.933, %.15.0.ph.i35
  %.44.i37 = call double @llvm.fabs.f64(double %.43.i36)
  %.45.i38 = fmul double %.44.i37, 2.000000e-02
  %.46.i39 = fsub double %.933, %arg.old
  %.47.i40 = call double @llvm.fabs.f64(double %.46.i39)
  %.48.i41 = fmul double %.47.i40, 4.000000e+00
  %.10.i.i42 = fcmp ogt double %.48.i41, %.45.i38
  %.11.i.i43 = select i1 %.10.i.i42, double %.48.i41, double %.45.i38
  %.10.i1.i44 = fcmp ogt double %.15.0.ph.i35, %.933
  %.11.i2.i45 = select i1 %.10.i1.i44, double %.15.0.ph.i35, double %.933
  %.10.i3.i46 = fcmp olt double %.11.i.i43, 1.000000e-09
  %.11.i4.i47 = select i1 %.10.i3.i46, double 1.000000e-09, double %.11.i.i43
  %.133.i48 = fadd double %.11.i2.i45, %.11.i4.i47
  store i64 0, ptr %.972, align 8
  %.982 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks13choose_blocksB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIxLi1E1C7mutable7alignedE(ptr nonnull %.972, ptr nonnull %excinfo.7, ptr %arg.rows.0.0, ptr %arg.rows.0.1, i64 %arg.rows.0.2, i64 %arg.rows.0.3, ptr %arg.rows.0.4, i64 %arg.rows.0.5.0, i64 %arg.rows.0.6.0, ptr %arg.lowest.0, ptr %arg.lowest.1, i64 %arg.lowest.2, i64 %arg.lowest.3, ptr %arg.lowest.4, i64 %arg.lowest.5.0, i64 %arg.lowest.6.0, i64 %at.2.1, i64 %.285.1, double %.133.i48, ptr %arg.blocks.2.0, ptr %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0)
  %.992 = load i64, ptr %.972, align 8
  %cond66 = icmp eq i32 %.982, 0
  br i1 %cond66, label %B426.endif.endif, label %B426.endif.if.if, !prof !0

B426.if.if:                                       ; preds = %B426.preheader, %end.endif.endif.if.if.i.i50
  %excinfo.6.1.ph = phi ptr [ @.const.picklebuf.dc3bba832c4c3758273d0db24b835691af3f316c.28, %end.endif.endif.if.if.i.i50 ], [ @.const.picklebuf.917b4fd376f3111025427fa1537059f6520d9ca7, %B426.preheader ]
  store ptr %excinfo.6.1.ph, ptr %excinfo, align 8
  br label %common.ret

B426.endif.endif:                                 ; preds = %B426.endif
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1014, i8 0, i64 16, i1 false)
  %.1069 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks14balance_blocksB3v40B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedExx213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEd(ptr nonnull %.1014, ptr nonnull %excinfo.8, double %arg.control.0, ptr %arg.law.0.0, ptr %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr %arg.law.1.0, ptr %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr %arg.law.2.0, ptr %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr %arg.blocks.0.0, ptr %arg.blocks.0.1, i64 %arg.blocks.0.2, i64 %arg.blocks.0.3, ptr %arg.blocks.0.4, i64 %arg.blocks.0.5.0, i64 %arg.blocks.0.5.1, i64 %arg.blocks.0.5.2, i64 %arg.blocks.0.6.0, i64 %arg.blocks.0.6.1, i64 %arg.blocks.0.6.2, ptr %arg.blocks.1.0, ptr %arg.blocks.1.1, i64 %arg.blocks.1.2, i64 %arg.blocks.1.3, ptr %arg.blocks.1.4, i64 %arg.blocks.1.5.0, i64 %arg.blocks.1.6.0, ptr %arg.blocks.2.0, ptr %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0, ptr %arg.blocks.3.0.0, ptr %arg.blocks.3.0.1, i64 %arg.blocks.3.0.2, i64 %arg.blocks.3.0.3, ptr %arg.blocks.3.0.4, i64 %arg.blocks.3.0.5.0, i64 %arg.blocks.3.0.6.0, ptr %arg.blocks.3.1.0, ptr %arg.blocks.3.1.1, i64 %arg.blocks.3.1.2, i64 %arg.blocks.3.1.3, ptr %arg.blocks.3.1.4, i64 %arg.blocks.3.1.5.0, i64 %arg.blocks.3.1.6.0, ptr %arg.blocks.3.2.0, ptr %arg.blocks.3.2.1, i64 %arg.blocks.3.2.2, i64 %arg.blocks.3.2.3, ptr %arg.blocks.3.2.4, i64 %arg.blocks.3.2.5.0, i64 %arg.blocks.3.2.6.0, ptr %arg.blocks.3.3.0, ptr %arg.blocks.3.3.1, i64 %arg.blocks.3.3.2, i64 %arg.blocks.3.3.3, ptr %arg.blocks.3.3.4, i64 %arg.blocks.3.3.5.0, i64 %arg.blocks.3.3.6.0, ptr %arg.blocks.3.4.0, ptr %arg.blocks.3.4.1, i64 %arg.blocks.3.4.2, i64 %arg.blocks.3.4.3, ptr %arg.blocks.3.4.4, i64 %arg.blocks.3.4.5.0, i64 %arg.blocks.3.4.6.0, ptr %arg.blocks.3.5.0, ptr %arg.blocks.3.5.1, i64 %arg.blocks.3.5.2, i64 %arg.blocks.3.5.3, ptr %arg.blocks.3.5.4, i64 %arg.blocks.3.5.5.0, i64 %arg.blocks.3.5.6.0, ptr %arg.p.0, ptr %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1, ptr %arg.older.0, ptr %arg.older.1, i64 %arg.older.2, i64 %arg.older.3, ptr %arg.older.4, i64 %arg.older.5.0, i64 %arg.older.5.1, i64 %arg.older.6.0, i64 %arg.older.6.1, i64 %arg.step, i64 %.992, ptr %arg.rows.0.0, ptr %arg.rows.0.1, i64 %arg.rows.0.2, i64 %arg.rows.0.3, ptr %arg.rows.0.4, i64 %arg.rows.0.5.0, i64 %arg.rows.0.6.0, ptr %arg.rows.1.0.0, ptr %arg.rows.1.0.1, i64 %arg.rows.1.0.2, i64 %arg.rows.1.0.3, ptr %arg.rows.1.0.4, i64 %arg.rows.1.0.5.0, i64 %arg.rows.1.0.5.1, i64 %arg.rows.1.0.6.0, i64 %arg.rows.1.0.6.1, ptr %arg.rows.1.1.0, ptr %arg.rows.1.1.1, i64 %arg.rows.1.1.2, i64 %arg.rows.1.1.3, ptr nonnull %arg.rows.1.1.4, i64 %arg.rows.1.1.5.0, i64 %arg.rows.1.1.6.0, ptr %arg.rows.1.2.0, ptr %arg.rows.1.2.1, i64 %arg.rows.1.2.2, i64 %arg.rows.1.2.3, ptr %arg.rows.1.2.4, i64 %arg.rows.1.2.5.0, i64 %arg.rows.1.2.6.0, ptr %arg.rows.2.0, ptr %arg.rows.2.1, i64 %arg.rows.2.2, i64 %arg.rows.2.3, ptr %arg.rows.2.4, i64 %arg.rows.2.5.0, i64 %arg.rows.2.6.0, ptr %arg.here.0.0, ptr %arg.here.0.1, i64 %.459, i64 %arg.here.0.3, ptr %.483, i64 %.459, i64 %arg.here.0.6.1, double %arg.old)
  %cond67 = icmp eq i32 %.1069, 0
  br i1 %cond67, label %B426.endif.endif.endif, label %B426.endif.endif.if.if, !prof !0

B426.endif.if.if:                                 ; preds = %B426.endif
  store ptr null, ptr %excinfo, align 8
  br label %common.ret

B426.endif.endif.endif:                           ; preds = %B426.endif.endif
  %.1128 = load double, ptr %arg.rows.1.1.4, align 8
  %.1129 = fcmp ogt double %.1128, %.133.i48
  br i1 %.1129, label %B426, label %B650.else.loopexit

B426.endif.endif.if.if:                           ; preds = %B426.endif.endif
  %.1077 = icmp sgt i32 %.1069, 0
  %.1070 = load ptr, ptr %excinfo.8, align 8
  %.1078 = select i1 %.1077, ptr %.1070, ptr undef
  store ptr %.1078, ptr %excinfo, align 8
  br label %common.ret

B650.else.loopexit:                               ; preds = %B426.endif.endif.endif
  %sunkaddr231 = getelementptr inbounds i8, ptr %.1014, i64 8
  %.1079.fca.1.load = load i64, ptr %sunkaddr231, align 8
  br label %B650.else

B650.else:                                        ; preds = %B650.else.loopexit, %B328.endif
  %cap.4.1 = phi double [ %cap.3.1, %B328.endif ], [ %.133.i48, %B650.else.loopexit ]
  %count.4.1 = phi i64 [ %count.3.1, %B328.endif ], [ %.992, %B650.else.loopexit ]
  %d.2.1.in = phi ptr [ %.777, %B328.endif ], [ %.1014, %B650.else.loopexit ]
  %passes.2.1 = phi i64 [ %.842.fca.1.load, %B328.endif ], [ %.1079.fca.1.load, %B650.else.loopexit ]
  %d.2.1 = load double, ptr %d.2.1.in, align 8
  %.1198 = icmp slt i64 %arg.rows.0.5.0, 1
  br i1 %.1198, label %B650.else.endif.if, label %B650.else.endif.endif, !prof !11

B650.endif:                                       ; preds = %B650.else.endif.endif.endif.if, %B650.else.endif.endif.endif
  %.1178.sroa.13.0 = phi i64 [ %.1178.sroa.13.1, %B650.else.endif.endif.endif ], [ %arg.rows.0.5.0, %B650.else.endif.endif.endif.if ]
  %.1266 = sub i64 %.1178.sroa.13.0, %.1178.sroa.0.3
  %.1275 = tail call i64 @llvm.smax.i64(i64 %.1266, i64 0)
  %.1291 = getelementptr i64, ptr %arg.rows.0.4, i64 %.1178.sroa.0.3
  %.1350 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks12press_blocksB3v57B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEd(ptr nonnull %.1328, ptr nonnull %excinfo.9, ptr %arg.law.0.0, ptr %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr %arg.law.1.0, ptr %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr %arg.law.2.0, ptr %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr %arg.blocks.2.0, ptr %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0, ptr %arg.older.0, ptr %arg.older.1, i64 %arg.older.2, i64 %arg.older.3, ptr %arg.older.4, i64 %arg.older.5.0, i64 %arg.older.5.1, i64 %arg.older.6.0, i64 %arg.older.6.1, ptr %arg.rows.0.0, ptr %arg.rows.0.1, i64 %.1275, i64 %arg.rows.0.3, ptr %.1291, i64 %.1275, i64 %arg.rows.0.6.0, ptr %arg.rows.1.0.0, ptr %arg.rows.1.0.1, i64 %arg.rows.1.0.2, i64 %arg.rows.1.0.3, ptr %arg.rows.1.0.4, i64 %arg.rows.1.0.5.0, i64 %arg.rows.1.0.5.1, i64 %arg.rows.1.0.6.0, i64 %arg.rows.1.0.6.1, double %d.2.1)
  %cond68 = icmp eq i32 %.1350, 0
  br i1 %cond68, label %B650.endif.endif, label %B650.endif.if.if, !prof !0

B650.else.endif.if:                               ; preds = %B650.else
  br label %B650.else.endif.endif

B650.else.endif.endif:                            ; preds = %B650.else.endif.if, %B650.else
  %.1178.sroa.0.3 = phi i64 [ %arg.rows.0.5.0, %B650.else.endif.if ], [ 0, %B650.else ]
  %.1205 = icmp slt i64 %count.4.1, 0
  %.1206 = select i1 %.1205, i64 %arg.rows.0.5.0, i64 0
  %.1207 = add i64 %.1206, %count.4.1
  %.1210 = icmp slt i64 %.1207, 0
  br i1 %.1210, label %B650.else.endif.endif.if, label %B650.else.endif.endif.endif, !prof !11

B650.else.endif.endif.if:                         ; preds = %B650.else.endif.endif
  br label %B650.else.endif.endif.endif

B650.else.endif.endif.endif:                      ; preds = %B650.else.endif.endif.if, %B650.else.endif.endif
  %.1178.sroa.13.1 = phi i64 [ 0, %B650.else.endif.endif.if ], [ %.1207, %B650.else.endif.endif ]
  %.1215.not = icmp slt i64 %.1207, %arg.rows.0.5.0
  br i1 %.1215.not, label %B650.endif, label %B650.else.endif.endif.endif.if, !prof !12

B650.else.endif.endif.endif.if:                   ; preds = %B650.else.endif.endif.endif
  br label %B650.endif

B650.endif.endif:                                 ; preds = %B650.endif
  store double %d.2.1, ptr %retptr, align 8
  %retptr.repack890 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store i64 %passes.2.1, ptr %retptr.repack890, align 8
  %retptr.repack892 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store i64 %at.2.1, ptr %retptr.repack892, align 8
  %retptr.repack892.repack894 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store double %cap.4.1, ptr %retptr.repack892.repack894, align 8
  %retptr.repack892.repack896 = getelementptr inbounds nuw i8, ptr %retptr, i64 32
  store double %chosen.2.1, ptr %retptr.repack892.repack896, align 8
  %retptr.repack892.repack898 = getelementptr inbounds nuw i8, ptr %retptr, i64 40
  store i64 %count.4.1, ptr %retptr.repack892.repack898, align 8
  br label %common.ret

B650.endif.if.if:                                 ; preds = %B650.endif
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define linkonce_odr noundef range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels5scene12march_blocks13choose_blocksB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIxLi1E1C7mutable7alignedE(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.active.0, ptr readnone captures(none) %arg.active.1, i64 %arg.active.2, i64 %arg.active.3, ptr writeonly captures(none) %arg.active.4, i64 %arg.active.5.0, i64 %arg.active.6.0, ptr readnone captures(none) %arg.lowest.0, ptr readnone captures(none) %arg.lowest.1, i64 %arg.lowest.2, i64 %arg.lowest.3, ptr readonly captures(none) %arg.lowest.4, i64 %arg.lowest.5.0, i64 %arg.lowest.6.0, i64 %arg.begin, i64 %arg.n, double %arg.cap, ptr readnone captures(none) %arg.pressed.0, ptr readnone captures(none) %arg.pressed.1, i64 %arg.pressed.2, i64 %arg.pressed.3, ptr readonly captures(none) %arg.pressed.4, i64 %arg.pressed.5.0, i64 %arg.pressed.6.0) local_unnamed_addr #9 {
B0.endif:
  %.137187.not = icmp slt i64 %arg.pressed.2, 1
  br i1 %.137187.not, label %common.ret, label %B50.lr.ph

B50.lr.ph:                                        ; preds = %B0.endif
  %.181 = add i64 %arg.begin, -16
  %.186 = icmp eq i64 %arg.n, 0
  %.228 = shl nsw i64 %arg.n, 1
  br i1 %.186, label %B50.endif.endif.else.if.us.preheader, label %B50.preheader, !prof !11

B50.preheader:                                    ; preds = %B50.lr.ph
  %const = bitcast i64 9223372036854775800 to i64
  br label %B50

B50.endif.endif.else.if.us.preheader:             ; preds = %B50.lr.ph
  %xtraiter8 = and i64 %arg.pressed.2, 7
  %0 = icmp samesign ult i64 %arg.pressed.2, 8
  br i1 %0, label %B50.endif.endif.else.if.us.epil.preheader, label %B50.endif.endif.else.if.us.preheader.new

B50.endif.endif.else.if.us.preheader.new:         ; preds = %B50.endif.endif.else.if.us.preheader
  %const60 = bitcast i64 9223372036854775800 to i64
  %unroll_iter = and i64 %arg.pressed.2, %const60
  %1 = lshr i64 %arg.pressed.2, 3
  %2 = trunc i64 %1 to i60
  %3 = zext i60 %2 to i64
  %4 = mul nsw i64 %3, -8
  br label %B50.endif.endif.else.if.us

B50.endif.endif.else.if.us:                       ; preds = %B334.us.7, %B50.endif.endif.else.if.us.preheader.new
  %lsr.iv14 = phi i64 [ %lsr.iv.next15, %B334.us.7 ], [ 7, %B50.endif.endif.else.if.us.preheader.new ]
  %count.2.0192.us = phi i64 [ 0, %B50.endif.endif.else.if.us.preheader.new ], [ %count.3.1.us.7, %B334.us.7 ]
  %5 = add i64 %lsr.iv14, -7
  %6 = add i64 %lsr.iv14, -6
  %7 = shl i64 %lsr.iv14, 3
  %scevgep27 = getelementptr i8, ptr %arg.pressed.4, i64 %7
  %scevgep28 = getelementptr i8, ptr %scevgep27, i64 -56
  %.288.us = load i64, ptr %scevgep28, align 8
  %.289.us = icmp sgt i64 %.288.us, 0
  br i1 %.289.us, label %B314.us, label %B334.us

B314.us:                                          ; preds = %B50.endif.endif.else.if.us
  %.575.us = icmp slt i64 %count.2.0192.us, 0
  %.576.us = select i1 %.575.us, i64 %arg.active.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.active.4, i64 %count.2.0192.us
  %.590.us = getelementptr i64, ptr %8, i64 %.576.us
  store i64 %5, ptr %.590.us, align 8
  %.595.us = add nsw i64 %count.2.0192.us, 1
  br label %B334.us

B334.us:                                          ; preds = %B314.us, %B50.endif.endif.else.if.us
  %count.3.1.us = phi i64 [ %.595.us, %B314.us ], [ %count.2.0192.us, %B50.endif.endif.else.if.us ]
  %9 = add i64 %lsr.iv14, -5
  %10 = shl i64 %lsr.iv14, 3
  %scevgep29 = getelementptr i8, ptr %arg.pressed.4, i64 %10
  %scevgep30 = getelementptr i8, ptr %scevgep29, i64 -48
  %.288.us.1 = load i64, ptr %scevgep30, align 8
  %.289.us.1 = icmp sgt i64 %.288.us.1, 0
  br i1 %.289.us.1, label %B314.us.1, label %B334.us.1

B314.us.1:                                        ; preds = %B334.us
  %.575.us.1 = icmp slt i64 %count.3.1.us, 0
  %.576.us.1 = select i1 %.575.us.1, i64 %arg.active.5.0, i64 0
  %11 = getelementptr i64, ptr %arg.active.4, i64 %count.3.1.us
  %.590.us.1 = getelementptr i64, ptr %11, i64 %.576.us.1
  store i64 %6, ptr %.590.us.1, align 8
  %.595.us.1 = add nsw i64 %count.3.1.us, 1
  br label %B334.us.1

B334.us.1:                                        ; preds = %B314.us.1, %B334.us
  %count.3.1.us.1 = phi i64 [ %.595.us.1, %B314.us.1 ], [ %count.3.1.us, %B334.us ]
  %12 = add i64 %lsr.iv14, -4
  %13 = shl i64 %lsr.iv14, 3
  %scevgep25 = getelementptr i8, ptr %arg.pressed.4, i64 %13
  %scevgep26 = getelementptr i8, ptr %scevgep25, i64 -40
  %.288.us.2 = load i64, ptr %scevgep26, align 8
  %.289.us.2 = icmp sgt i64 %.288.us.2, 0
  br i1 %.289.us.2, label %B314.us.2, label %B334.us.2

B314.us.2:                                        ; preds = %B334.us.1
  %.575.us.2 = icmp slt i64 %count.3.1.us.1, 0
  %.576.us.2 = select i1 %.575.us.2, i64 %arg.active.5.0, i64 0
  %14 = getelementptr i64, ptr %arg.active.4, i64 %count.3.1.us.1
  %.590.us.2 = getelementptr i64, ptr %14, i64 %.576.us.2
  store i64 %9, ptr %.590.us.2, align 8
  %.595.us.2 = add nsw i64 %count.3.1.us.1, 1
  br label %B334.us.2

B334.us.2:                                        ; preds = %B314.us.2, %B334.us.1
  %count.3.1.us.2 = phi i64 [ %.595.us.2, %B314.us.2 ], [ %count.3.1.us.1, %B334.us.1 ]
  %15 = add i64 %lsr.iv14, -3
  %16 = shl i64 %lsr.iv14, 3
  %scevgep23 = getelementptr i8, ptr %arg.pressed.4, i64 %16
  %scevgep24 = getelementptr i8, ptr %scevgep23, i64 -32
  %.288.us.3 = load i64, ptr %scevgep24, align 8
  %.289.us.3 = icmp sgt i64 %.288.us.3, 0
  br i1 %.289.us.3, label %B314.us.3, label %B334.us.3

B314.us.3:                                        ; preds = %B334.us.2
  %.575.us.3 = icmp slt i64 %count.3.1.us.2, 0
  %.576.us.3 = select i1 %.575.us.3, i64 %arg.active.5.0, i64 0
  %17 = getelementptr i64, ptr %arg.active.4, i64 %count.3.1.us.2
  %.590.us.3 = getelementptr i64, ptr %17, i64 %.576.us.3
  store i64 %12, ptr %.590.us.3, align 8
  %.595.us.3 = add nsw i64 %count.3.1.us.2, 1
  br label %B334.us.3

B334.us.3:                                        ; preds = %B314.us.3, %B334.us.2
  %count.3.1.us.3 = phi i64 [ %.595.us.3, %B314.us.3 ], [ %count.3.1.us.2, %B334.us.2 ]
  %18 = add i64 %lsr.iv14, -2
  %19 = shl i64 %lsr.iv14, 3
  %scevgep21 = getelementptr i8, ptr %arg.pressed.4, i64 %19
  %scevgep22 = getelementptr i8, ptr %scevgep21, i64 -24
  %.288.us.4 = load i64, ptr %scevgep22, align 8
  %.289.us.4 = icmp sgt i64 %.288.us.4, 0
  br i1 %.289.us.4, label %B314.us.4, label %B334.us.4

B314.us.4:                                        ; preds = %B334.us.3
  %.575.us.4 = icmp slt i64 %count.3.1.us.3, 0
  %.576.us.4 = select i1 %.575.us.4, i64 %arg.active.5.0, i64 0
  %20 = getelementptr i64, ptr %arg.active.4, i64 %count.3.1.us.3
  %.590.us.4 = getelementptr i64, ptr %20, i64 %.576.us.4
  store i64 %15, ptr %.590.us.4, align 8
  %.595.us.4 = add nsw i64 %count.3.1.us.3, 1
  br label %B334.us.4

B334.us.4:                                        ; preds = %B314.us.4, %B334.us.3
  %count.3.1.us.4 = phi i64 [ %.595.us.4, %B314.us.4 ], [ %count.3.1.us.3, %B334.us.3 ]
  %21 = add i64 %lsr.iv14, -1
  %22 = shl i64 %lsr.iv14, 3
  %scevgep19 = getelementptr i8, ptr %arg.pressed.4, i64 %22
  %scevgep20 = getelementptr i8, ptr %scevgep19, i64 -16
  %.288.us.5 = load i64, ptr %scevgep20, align 8
  %.289.us.5 = icmp sgt i64 %.288.us.5, 0
  br i1 %.289.us.5, label %B314.us.5, label %B334.us.5

B314.us.5:                                        ; preds = %B334.us.4
  %.575.us.5 = icmp slt i64 %count.3.1.us.4, 0
  %.576.us.5 = select i1 %.575.us.5, i64 %arg.active.5.0, i64 0
  %23 = getelementptr i64, ptr %arg.active.4, i64 %count.3.1.us.4
  %.590.us.5 = getelementptr i64, ptr %23, i64 %.576.us.5
  store i64 %18, ptr %.590.us.5, align 8
  %.595.us.5 = add nsw i64 %count.3.1.us.4, 1
  br label %B334.us.5

B334.us.5:                                        ; preds = %B314.us.5, %B334.us.4
  %count.3.1.us.5 = phi i64 [ %.595.us.5, %B314.us.5 ], [ %count.3.1.us.4, %B334.us.4 ]
  %24 = shl i64 %lsr.iv14, 3
  %scevgep17 = getelementptr i8, ptr %arg.pressed.4, i64 %24
  %scevgep18 = getelementptr i8, ptr %scevgep17, i64 -8
  %.288.us.6 = load i64, ptr %scevgep18, align 8
  %.289.us.6 = icmp sgt i64 %.288.us.6, 0
  br i1 %.289.us.6, label %B314.us.6, label %B334.us.6

B314.us.6:                                        ; preds = %B334.us.5
  %.575.us.6 = icmp slt i64 %count.3.1.us.5, 0
  %.576.us.6 = select i1 %.575.us.6, i64 %arg.active.5.0, i64 0
  %25 = getelementptr i64, ptr %arg.active.4, i64 %count.3.1.us.5
  %.590.us.6 = getelementptr i64, ptr %25, i64 %.576.us.6
  store i64 %21, ptr %.590.us.6, align 8
  %.595.us.6 = add nsw i64 %count.3.1.us.5, 1
  br label %B334.us.6

B334.us.6:                                        ; preds = %B314.us.6, %B334.us.5
  %count.3.1.us.6 = phi i64 [ %.595.us.6, %B314.us.6 ], [ %count.3.1.us.5, %B334.us.5 ]
  %26 = shl i64 %lsr.iv14, 3
  %scevgep16 = getelementptr i8, ptr %arg.pressed.4, i64 %26
  %.288.us.7 = load i64, ptr %scevgep16, align 8
  %.289.us.7 = icmp sgt i64 %.288.us.7, 0
  br i1 %.289.us.7, label %B314.us.7, label %B334.us.7

B314.us.7:                                        ; preds = %B334.us.6
  %.575.us.7 = icmp slt i64 %count.3.1.us.6, 0
  %.576.us.7 = select i1 %.575.us.7, i64 %arg.active.5.0, i64 0
  %27 = getelementptr i64, ptr %arg.active.4, i64 %count.3.1.us.6
  %.590.us.7 = getelementptr i64, ptr %27, i64 %.576.us.7
  store i64 %lsr.iv14, ptr %.590.us.7, align 8
  %.595.us.7 = add nsw i64 %count.3.1.us.6, 1
  br label %B334.us.7

B334.us.7:                                        ; preds = %B314.us.7, %B334.us.6
  %count.3.1.us.7 = phi i64 [ %.595.us.7, %B314.us.7 ], [ %count.3.1.us.6, %B334.us.6 ]
  %lsr.iv.next15 = add nuw nsw i64 %lsr.iv14, 8
  %28 = add i64 %4, %lsr.iv.next15
  %niter.ncmp.7 = icmp eq i64 %28, 7
  br i1 %niter.ncmp.7, label %common.ret.loopexit.unr-lcssa, label %B50.endif.endif.else.if.us

B50:                                              ; preds = %B50.preheader, %B334
  %count.2.0192 = phi i64 [ %count.3.1, %B334 ], [ 0, %B50.preheader ]
  %.143180190 = phi i64 [ %.150, %B334 ], [ 0, %B50.preheader ]
  %29 = icmp ne i64 %arg.n, -1
  %.150 = add nuw nsw i64 %.143180190, 1
  %.179 = shl nsw i64 %.143180190, 6
  %.182 = add i64 %.181, %.179
  %const_mat = add i64 %const, 8
  %.197 = icmp ne i64 %.182, %const_mat
  %.199.not = or i1 %29, %.197
  br i1 %.199.not, label %B50.else.if, label %B50.endif.endif.else.if, !prof !12

B278:                                             ; preds = %B278.preheader12, %B306.7
  %lsr.iv35 = phi i64 [ %68, %B278.preheader12 ], [ %lsr.iv.next36, %B306.7 ]
  %touchable.2.1176 = phi i1 [ %"$phi306.2.2.2.7", %B306.7 ], [ %touchable.2.1176.unr, %B278.preheader12 ]
  %.459172174 = phi i64 [ %.466.75, %B306.7 ], [ %.459172174.unr, %B278.preheader12 ]
  br i1 %touchable.2.1176, label %B306.7, label %B284

B284:                                             ; preds = %B278
  %.516 = icmp slt i64 %.459172174, 0
  %.517 = select i1 %.516, i64 %arg.lowest.5.0, i64 0
  %30 = shl i64 %.517, 3
  %scevgep58 = getelementptr i8, ptr %arg.lowest.4, i64 %30
  %31 = shl i64 %.459172174, 3
  %scevgep59 = getelementptr i8, ptr %scevgep58, i64 %31
  %.532 = load double, ptr %scevgep59, align 8
  %.536 = fcmp olt double %.532, %arg.cap
  br i1 %.536, label %B306.7, label %B284.1

B284.1:                                           ; preds = %B284
  %.516.1 = icmp slt i64 %.459172174, -1
  %.517.1 = select i1 %.516.1, i64 %arg.lowest.5.0, i64 0
  %32 = shl i64 %.517.1, 3
  %scevgep55 = getelementptr i8, ptr %arg.lowest.4, i64 %32
  %33 = shl i64 %.459172174, 3
  %scevgep56 = getelementptr i8, ptr %scevgep55, i64 %33
  %scevgep57 = getelementptr i8, ptr %scevgep56, i64 8
  %.532.1 = load double, ptr %scevgep57, align 8
  %.536.1 = fcmp olt double %.532.1, %arg.cap
  br i1 %.536.1, label %B306.7, label %B284.2

B284.2:                                           ; preds = %B284.1
  %.516.2 = icmp slt i64 %.459172174, -2
  %.517.2 = select i1 %.516.2, i64 %arg.lowest.5.0, i64 0
  %34 = shl i64 %.517.2, 3
  %scevgep52 = getelementptr i8, ptr %arg.lowest.4, i64 %34
  %35 = shl i64 %.459172174, 3
  %scevgep53 = getelementptr i8, ptr %scevgep52, i64 %35
  %scevgep54 = getelementptr i8, ptr %scevgep53, i64 16
  %.532.2 = load double, ptr %scevgep54, align 8
  %.536.2 = fcmp olt double %.532.2, %arg.cap
  br i1 %.536.2, label %B306.7, label %B284.3

B284.3:                                           ; preds = %B284.2
  %.516.3 = icmp slt i64 %.459172174, -3
  %.517.3 = select i1 %.516.3, i64 %arg.lowest.5.0, i64 0
  %36 = shl i64 %.517.3, 3
  %scevgep49 = getelementptr i8, ptr %arg.lowest.4, i64 %36
  %37 = shl i64 %.459172174, 3
  %scevgep50 = getelementptr i8, ptr %scevgep49, i64 %37
  %scevgep51 = getelementptr i8, ptr %scevgep50, i64 24
  %.532.3 = load double, ptr %scevgep51, align 8
  %.536.3 = fcmp olt double %.532.3, %arg.cap
  br i1 %.536.3, label %B306.7, label %B284.4

B284.4:                                           ; preds = %B284.3
  %.516.4 = icmp slt i64 %.459172174, -4
  %.517.4 = select i1 %.516.4, i64 %arg.lowest.5.0, i64 0
  %38 = shl i64 %.517.4, 3
  %scevgep46 = getelementptr i8, ptr %arg.lowest.4, i64 %38
  %39 = shl i64 %.459172174, 3
  %scevgep47 = getelementptr i8, ptr %scevgep46, i64 %39
  %scevgep48 = getelementptr i8, ptr %scevgep47, i64 32
  %.532.4 = load double, ptr %scevgep48, align 8
  %.536.4 = fcmp olt double %.532.4, %arg.cap
  br i1 %.536.4, label %B306.7, label %B284.5

B284.5:                                           ; preds = %B284.4
  %.516.5 = icmp slt i64 %.459172174, -5
  %.517.5 = select i1 %.516.5, i64 %arg.lowest.5.0, i64 0
  %40 = shl i64 %.517.5, 3
  %scevgep43 = getelementptr i8, ptr %arg.lowest.4, i64 %40
  %41 = shl i64 %.459172174, 3
  %scevgep44 = getelementptr i8, ptr %scevgep43, i64 %41
  %scevgep45 = getelementptr i8, ptr %scevgep44, i64 40
  %.532.5 = load double, ptr %scevgep45, align 8
  %.536.5 = fcmp olt double %.532.5, %arg.cap
  br i1 %.536.5, label %B306.7, label %B306.6

B306.6:                                           ; preds = %B284.5
  %.516.6 = icmp slt i64 %.459172174, -6
  %.517.6 = select i1 %.516.6, i64 %arg.lowest.5.0, i64 0
  %42 = shl i64 %.517.6, 3
  %scevgep40 = getelementptr i8, ptr %arg.lowest.4, i64 %42
  %43 = shl i64 %.459172174, 3
  %scevgep41 = getelementptr i8, ptr %scevgep40, i64 %43
  %scevgep42 = getelementptr i8, ptr %scevgep41, i64 48
  %.532.6 = load double, ptr %scevgep42, align 8
  %.536.6 = fcmp olt double %.532.6, %arg.cap
  br i1 %.536.6, label %B306.7, label %B284.7

B284.7:                                           ; preds = %B306.6
  %.516.7 = icmp slt i64 %.459172174, -7
  %.517.7 = select i1 %.516.7, i64 %arg.lowest.5.0, i64 0
  %44 = shl i64 %.517.7, 3
  %scevgep37 = getelementptr i8, ptr %arg.lowest.4, i64 %44
  %45 = shl i64 %.459172174, 3
  %scevgep38 = getelementptr i8, ptr %scevgep37, i64 %45
  %scevgep39 = getelementptr i8, ptr %scevgep38, i64 56
  %.532.7 = load double, ptr %scevgep39, align 8
  %.536.7 = fcmp olt double %.532.7, %arg.cap
  br label %B306.7

B306.7:                                           ; preds = %B284.7, %B306.6, %B284.5, %B284.4, %B284.3, %B284.2, %B284.1, %B284, %B278
  %"$phi306.2.2.2.7" = phi i1 [ true, %B306.6 ], [ %.536.7, %B284.7 ], [ true, %B284.5 ], [ true, %B284.3 ], [ true, %B284.1 ], [ true, %B278 ], [ true, %B284 ], [ true, %B284.2 ], [ true, %B284.4 ]
  %.466.75 = add nsw i64 %.459172174, 8
  %lsr.iv.next36 = add nsw i64 %lsr.iv35, -8
  %.453.7 = icmp sgt i64 %lsr.iv.next36, 8
  br i1 %.453.7, label %B278, label %B310

B310:                                             ; preds = %B306.7, %B278.prol.loopexit, %B50.endif.endif.else.if
  %touchable.2.1.lcssa = phi i1 [ %.289, %B50.endif.endif.else.if ], [ %"$phi306.2.2.2.lcssa.unr", %B278.prol.loopexit ], [ %"$phi306.2.2.2.7", %B306.7 ]
  br i1 %touchable.2.1.lcssa, label %B314, label %B334

B314:                                             ; preds = %B310
  %.575 = icmp slt i64 %count.2.0192, 0
  %.576 = select i1 %.575, i64 %arg.active.5.0, i64 0
  %46 = getelementptr i64, ptr %arg.active.4, i64 %count.2.0192
  %.590 = getelementptr i64, ptr %46, i64 %.576
  store i64 %.143180190, ptr %.590, align 8
  %.595 = add nsw i64 %count.2.0192, 1
  br label %B334

B334:                                             ; preds = %B314, %B310
  %count.3.1 = phi i64 [ %.595, %B314 ], [ %count.2.0192, %B310 ]
  %exitcond.not = icmp eq i64 %.150, %arg.pressed.2
  br i1 %exitcond.not, label %common.ret, label %B50

common.ret.loopexit.unr-lcssa:                    ; preds = %B334.us.7
  %lcmp.mod9.not = icmp eq i64 %xtraiter8, 0
  br i1 %lcmp.mod9.not, label %common.ret, label %B50.endif.endif.else.if.us.epil.preheader

B50.endif.endif.else.if.us.epil.preheader:        ; preds = %common.ret.loopexit.unr-lcssa, %B50.endif.endif.else.if.us.preheader
  %count.2.0192.us.epil.init = phi i64 [ 0, %B50.endif.endif.else.if.us.preheader ], [ %count.3.1.us.7, %common.ret.loopexit.unr-lcssa ]
  %.143180190.us.epil.init = phi i64 [ 0, %B50.endif.endif.else.if.us.preheader ], [ %unroll_iter, %common.ret.loopexit.unr-lcssa ]
  br label %B50.endif.endif.else.if.us.epil

B50.endif.endif.else.if.us.epil:                  ; preds = %B334.us.epil, %B50.endif.endif.else.if.us.epil.preheader
  %lsr.iv = phi i64 [ %lsr.iv.next, %B334.us.epil ], [ %xtraiter8, %B50.endif.endif.else.if.us.epil.preheader ]
  %count.2.0192.us.epil = phi i64 [ %count.3.1.us.epil, %B334.us.epil ], [ %count.2.0192.us.epil.init, %B50.endif.endif.else.if.us.epil.preheader ]
  %.143180190.us.epil = phi i64 [ %.150.us.epil, %B334.us.epil ], [ %.143180190.us.epil.init, %B50.endif.endif.else.if.us.epil.preheader ]
  %47 = shl i64 %.143180190.us.epil, 3
  %scevgep = getelementptr i8, ptr %arg.pressed.4, i64 %47
  %.288.us.epil = load i64, ptr %scevgep, align 8
  %.289.us.epil = icmp sgt i64 %.288.us.epil, 0
  br i1 %.289.us.epil, label %B314.us.epil, label %B334.us.epil

B314.us.epil:                                     ; preds = %B50.endif.endif.else.if.us.epil
  %.575.us.epil = icmp slt i64 %count.2.0192.us.epil, 0
  %.576.us.epil = select i1 %.575.us.epil, i64 %arg.active.5.0, i64 0
  %48 = getelementptr i64, ptr %arg.active.4, i64 %count.2.0192.us.epil
  %.590.us.epil = getelementptr i64, ptr %48, i64 %.576.us.epil
  store i64 %.143180190.us.epil, ptr %.590.us.epil, align 8
  %.595.us.epil = add nsw i64 %count.2.0192.us.epil, 1
  br label %B334.us.epil

B334.us.epil:                                     ; preds = %B314.us.epil, %B50.endif.endif.else.if.us.epil
  %count.3.1.us.epil = phi i64 [ %.595.us.epil, %B314.us.epil ], [ %count.2.0192.us.epil, %B50.endif.endif.else.if.us.epil ]
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.150.us.epil = add nuw nsw i64 %.143180190.us.epil, 1
  %epil.iter.cmp.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %epil.iter.cmp.not, label %common.ret, label %B50.endif.endif.else.if.us.epil, !llvm.loop !264

common.ret:                                       ; preds = %B334, %B334.us.epil, %common.ret.loopexit.unr-lcssa, %B0.endif
  %count.2.0.lcssa = phi i64 [ 0, %B0.endif ], [ %count.3.1.us.epil, %B334.us.epil ], [ %count.3.1.us.7, %common.ret.loopexit.unr-lcssa ], [ %count.3.1, %B334 ]
  store i64 %count.2.0.lcssa, ptr %retptr, align 8
  ret i32 0

B50.else.if:                                      ; preds = %B50
  %49 = or i64 %.182, %arg.n
  %50 = and i64 %49, -4294967296
  %51 = icmp eq i64 %50, 0
  br i1 %51, label %52, label %57

52:                                               ; preds = %B50.else.if
  %53 = trunc i64 %arg.n to i32
  %54 = trunc i64 %.182 to i32
  %55 = urem i32 %54, %53
  %56 = zext i32 %55 to i64
  br label %59

57:                                               ; preds = %B50.else.if
  %58 = srem i64 %.182, %arg.n
  br label %59

59:                                               ; preds = %57, %52
  %60 = phi i64 [ %56, %52 ], [ %58, %57 ]
  %.204 = xor i64 %60, %arg.n
  %.205 = icmp slt i64 %.204, 0
  %.206 = icmp ne i64 %60, 0
  %.207 = and i1 %.206, %.205
  %.214 = select i1 %.207, i64 %arg.n, i64 0
  %spec.select = add i64 %.214, %60
  br label %B50.endif.endif.else.if

B50.endif.endif.else.if:                          ; preds = %59, %B50
  %rem.0 = phi i64 [ %spec.select, %59 ], [ 0, %B50 ]
  %.226 = add nsw i64 %rem.0, 96
  %.11.i1 = tail call i64 @llvm.smin.i64(i64 %.228, i64 %.226)
  %.257 = add nsw i64 %.11.i1, -1
  %61 = getelementptr i64, ptr %arg.pressed.4, i64 %.143180190
  %.288 = load i64, ptr %61, align 8
  %.289 = icmp sgt i64 %.288, 0
  %.300.1 = ashr i64 %rem.0, 4
  %.340.1 = ashr i64 %.257, 4
  %reass.sub = sub nsw i64 %.340.1, %.300.1
  %.453173 = icmp sgt i64 %reass.sub, -1
  br i1 %.453173, label %B278.preheader, label %B310

B278.preheader:                                   ; preds = %B50.endif.endif.else.if
  %..410 = add nuw nsw i64 %reass.sub, 1
  %xtraiter = and i64 %..410, 7
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B278.prol.loopexit, label %B278.prol.preheader

B278.prol.preheader:                              ; preds = %B278.preheader
  br label %B278.prol

B278.prol:                                        ; preds = %B278.prol.preheader, %B306.prol
  %lsr.iv33 = phi i64 [ %xtraiter, %B278.prol.preheader ], [ %lsr.iv.next34, %B306.prol ]
  %touchable.2.1176.prol = phi i1 [ %"$phi306.2.2.2.prol", %B306.prol ], [ %.289, %B278.prol.preheader ]
  %.459172174.prol = phi i64 [ %.466.prol, %B306.prol ], [ %.300.1, %B278.prol.preheader ]
  br i1 %touchable.2.1176.prol, label %B306.prol, label %B284.prol

B284.prol:                                        ; preds = %B278.prol
  %.516.prol = icmp slt i64 %.459172174.prol, 0
  %.517.prol = select i1 %.516.prol, i64 %arg.lowest.5.0, i64 0
  %62 = shl i64 %.517.prol, 3
  %scevgep31 = getelementptr i8, ptr %arg.lowest.4, i64 %62
  %63 = shl nsw i64 %.459172174.prol, 3
  %scevgep32 = getelementptr i8, ptr %scevgep31, i64 %63
  %.532.prol = load double, ptr %scevgep32, align 8
  %.536.prol = fcmp olt double %.532.prol, %arg.cap
  br label %B306.prol

B306.prol:                                        ; preds = %B284.prol, %B278.prol
  %"$phi306.2.2.2.prol" = phi i1 [ true, %B278.prol ], [ %.536.prol, %B284.prol ]
  %lsr.iv.next34 = add nsw i64 %lsr.iv33, -1
  %.466.prol = add nsw i64 %.459172174.prol, 1
  %prol.iter.cmp.not = icmp eq i64 %lsr.iv.next34, 0
  br i1 %prol.iter.cmp.not, label %B278.prol.loopexit.loopexit, label %B278.prol, !llvm.loop !265

B278.prol.loopexit.loopexit:                      ; preds = %B306.prol
  %64 = add nsw i64 %xtraiter, %.300.1
  %65 = add nsw i64 %.340.1, 1
  %66 = sub i64 %65, %.466.prol
  br label %B278.prol.loopexit

B278.prol.loopexit:                               ; preds = %B278.prol.loopexit.loopexit, %B278.preheader
  %touchable.2.1176.unr = phi i1 [ %.289, %B278.preheader ], [ %"$phi306.2.2.2.prol", %B278.prol.loopexit.loopexit ]
  %.452171175.unr = phi i64 [ %..410, %B278.preheader ], [ %66, %B278.prol.loopexit.loopexit ]
  %.459172174.unr = phi i64 [ %.300.1, %B278.preheader ], [ %64, %B278.prol.loopexit.loopexit ]
  %"$phi306.2.2.2.lcssa.unr" = phi i1 [ poison, %B278.preheader ], [ %"$phi306.2.2.2.prol", %B278.prol.loopexit.loopexit ]
  %67 = icmp ult i64 %reass.sub, 7
  br i1 %67, label %B310, label %B278.preheader12

B278.preheader12:                                 ; preds = %B278.prol.loopexit
  %68 = add nsw i64 %.452171175.unr, 8
  br label %B278
}

define linkonce_odr range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels5scene12march_blocks14balance_blocksB3v40B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedExx213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEd(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, double %arg.control.0, ptr readnone captures(none) %arg.law.0.0, ptr readnone captures(none) %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr readnone captures(none) %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr readnone captures(none) %arg.law.1.0, ptr readnone captures(none) %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr readnone captures(none) %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr readnone captures(none) %arg.law.2.0, ptr readnone captures(none) %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr readonly captures(none) %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr readnone captures(none) %arg.blocks.0.0, ptr readnone captures(none) %arg.blocks.0.1, i64 %arg.blocks.0.2, i64 %arg.blocks.0.3, ptr captures(address) %arg.blocks.0.4, i64 %arg.blocks.0.5.0, i64 %arg.blocks.0.5.1, i64 %arg.blocks.0.5.2, i64 %arg.blocks.0.6.0, i64 %arg.blocks.0.6.1, i64 %arg.blocks.0.6.2, ptr readnone captures(none) %arg.blocks.1.0, ptr readnone captures(none) %arg.blocks.1.1, i64 %arg.blocks.1.2, i64 %arg.blocks.1.3, ptr captures(none) %arg.blocks.1.4, i64 %arg.blocks.1.5.0, i64 %arg.blocks.1.6.0, ptr readnone captures(none) %arg.blocks.2.0, ptr readnone captures(none) %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr readonly captures(none) %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0, ptr readnone captures(none) %arg.blocks.3.0.0, ptr readnone captures(none) %arg.blocks.3.0.1, i64 %arg.blocks.3.0.2, i64 %arg.blocks.3.0.3, ptr readnone captures(none) %arg.blocks.3.0.4, i64 %arg.blocks.3.0.5.0, i64 %arg.blocks.3.0.6.0, ptr readnone captures(none) %arg.blocks.3.1.0, ptr readnone captures(none) %arg.blocks.3.1.1, i64 %arg.blocks.3.1.2, i64 %arg.blocks.3.1.3, ptr readonly captures(none) %arg.blocks.3.1.4, i64 %arg.blocks.3.1.5.0, i64 %arg.blocks.3.1.6.0, ptr readnone captures(none) %arg.blocks.3.2.0, ptr readnone captures(none) %arg.blocks.3.2.1, i64 %arg.blocks.3.2.2, i64 %arg.blocks.3.2.3, ptr readonly captures(none) %arg.blocks.3.2.4, i64 %arg.blocks.3.2.5.0, i64 %arg.blocks.3.2.6.0, ptr readnone captures(none) %arg.blocks.3.3.0, ptr readnone captures(none) %arg.blocks.3.3.1, i64 %arg.blocks.3.3.2, i64 %arg.blocks.3.3.3, ptr %arg.blocks.3.3.4, i64 %arg.blocks.3.3.5.0, i64 %arg.blocks.3.3.6.0, ptr readnone captures(none) %arg.blocks.3.4.0, ptr readnone captures(none) %arg.blocks.3.4.1, i64 %arg.blocks.3.4.2, i64 %arg.blocks.3.4.3, ptr %arg.blocks.3.4.4, i64 %arg.blocks.3.4.5.0, i64 %arg.blocks.3.4.6.0, ptr readnone captures(none) %arg.blocks.3.5.0, ptr readnone captures(none) %arg.blocks.3.5.1, i64 %arg.blocks.3.5.2, i64 %arg.blocks.3.5.3, ptr readonly captures(none) %arg.blocks.3.5.4, i64 %arg.blocks.3.5.5.0, i64 %arg.blocks.3.5.6.0, ptr readnone captures(none) %arg.p.0, ptr readnone captures(none) %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr readonly captures(none) %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1, ptr readnone captures(none) %arg.older.0, ptr readnone captures(none) %arg.older.1, i64 %arg.older.2, i64 %arg.older.3, ptr readonly captures(none) %arg.older.4, i64 %arg.older.5.0, i64 %arg.older.5.1, i64 %arg.older.6.0, i64 %arg.older.6.1, i64 %arg.step, i64 %arg.count, ptr readnone captures(none) %arg.rows.0.0, ptr readnone captures(none) %arg.rows.0.1, i64 %arg.rows.0.2, i64 %arg.rows.0.3, ptr readonly captures(none) %arg.rows.0.4, i64 %arg.rows.0.5.0, i64 %arg.rows.0.6.0, ptr %arg.rows.1.0.0, ptr readnone captures(none) %arg.rows.1.0.1, i64 %arg.rows.1.0.2, i64 %arg.rows.1.0.3, ptr %arg.rows.1.0.4, i64 %arg.rows.1.0.5.0, i64 %arg.rows.1.0.5.1, i64 %arg.rows.1.0.6.0, i64 %arg.rows.1.0.6.1, ptr %arg.rows.1.1.0, ptr readnone captures(none) %arg.rows.1.1.1, i64 %arg.rows.1.1.2, i64 %arg.rows.1.1.3, ptr captures(none) %arg.rows.1.1.4, i64 %arg.rows.1.1.5.0, i64 %arg.rows.1.1.6.0, ptr %arg.rows.1.2.0, ptr readnone captures(none) %arg.rows.1.2.1, i64 %arg.rows.1.2.2, i64 %arg.rows.1.2.3, ptr captures(none) %arg.rows.1.2.4, i64 %arg.rows.1.2.5.0, i64 %arg.rows.1.2.6.0, ptr readnone captures(none) %arg.rows.2.0, ptr readnone captures(none) %arg.rows.2.1, i64 %arg.rows.2.2, i64 %arg.rows.2.3, ptr captures(address) %arg.rows.2.4, i64 %arg.rows.2.5.0, i64 %arg.rows.2.6.0, ptr readnone captures(none) %arg.z.0, ptr readnone captures(none) %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr readonly captures(none) %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, double %arg.old) local_unnamed_addr {
B0.else:
  %.107.i = alloca { double, i64 }, align 8
  %excinfo.1.i = alloca ptr, align 8
  %.382 = alloca ptr, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.213 = add nsw i64 %arg.step, -1
  %.260 = icmp slt i64 %arg.rows.0.5.0, 1
  br i1 %.260, label %B0.else.endif.if, label %B0.else.endif.endif, !prof !11

B0.endif:                                         ; preds = %B0.else.endif.endif.endif.if, %B0.else.endif.endif.endif
  %.240.sroa.13.0 = phi i64 [ %.240.sroa.13.1, %B0.else.endif.endif.endif ], [ %arg.rows.0.5.0, %B0.else.endif.endif.endif.if ]
  %.328 = sub i64 %.240.sroa.13.0, %.240.sroa.0.3
  %.337 = tail call i64 @llvm.smax.i64(i64 %.328, i64 0)
  %.353 = getelementptr i64, ptr %arg.rows.0.4, i64 %.240.sroa.0.3
  %.438 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks8_predictB3v41B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_29(ptr nonnull %.382, ptr nonnull %excinfo.1, ptr %arg.law.0.0, ptr %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr %arg.law.1.0, ptr %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr %arg.law.2.0, ptr %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr %arg.blocks.0.0, ptr %arg.blocks.0.1, i64 %arg.blocks.0.2, i64 %arg.blocks.0.3, ptr %arg.blocks.0.4, i64 %arg.blocks.0.5.0, i64 %arg.blocks.0.5.1, i64 %arg.blocks.0.5.2, i64 %arg.blocks.0.6.0, i64 %arg.blocks.0.6.1, i64 %arg.blocks.0.6.2, ptr %arg.blocks.1.0, ptr %arg.blocks.1.1, i64 %arg.blocks.1.2, i64 %arg.blocks.1.3, ptr %arg.blocks.1.4, i64 %arg.blocks.1.5.0, i64 %arg.blocks.1.6.0, ptr %arg.blocks.2.0, ptr %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0, ptr %arg.blocks.3.0.0, ptr %arg.blocks.3.0.1, i64 %arg.blocks.3.0.2, i64 %arg.blocks.3.0.3, ptr %arg.blocks.3.0.4, i64 %arg.blocks.3.0.5.0, i64 %arg.blocks.3.0.6.0, ptr %arg.blocks.3.1.0, ptr %arg.blocks.3.1.1, i64 %arg.blocks.3.1.2, i64 %arg.blocks.3.1.3, ptr %arg.blocks.3.1.4, i64 %arg.blocks.3.1.5.0, i64 %arg.blocks.3.1.6.0, ptr %arg.blocks.3.2.0, ptr %arg.blocks.3.2.1, i64 %arg.blocks.3.2.2, i64 %arg.blocks.3.2.3, ptr %arg.blocks.3.2.4, i64 %arg.blocks.3.2.5.0, i64 %arg.blocks.3.2.6.0, ptr %arg.blocks.3.3.0, ptr %arg.blocks.3.3.1, i64 %arg.blocks.3.3.2, i64 %arg.blocks.3.3.3, ptr %arg.blocks.3.3.4, i64 %arg.blocks.3.3.5.0, i64 %arg.blocks.3.3.6.0, ptr %arg.blocks.3.4.0, ptr %arg.blocks.3.4.1, i64 %arg.blocks.3.4.2, i64 %arg.blocks.3.4.3, ptr %arg.blocks.3.4.4, i64 %arg.blocks.3.4.5.0, i64 %arg.blocks.3.4.6.0, ptr %arg.blocks.3.5.0, ptr %arg.blocks.3.5.1, i64 %arg.blocks.3.5.2, i64 %arg.blocks.3.5.3, ptr %arg.blocks.3.5.4, i64 %arg.blocks.3.5.5.0, i64 %arg.blocks.3.5.6.0, ptr %arg.p.0, ptr %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1, ptr %arg.older.0, ptr %arg.older.1, i64 %arg.older.2, i64 %arg.older.3, ptr %arg.older.4, i64 %arg.older.5.0, i64 %arg.older.5.1, i64 %arg.older.6.0, i64 %arg.older.6.1, i64 %.213, ptr %arg.rows.0.0, ptr %arg.rows.0.1, i64 %.337, i64 %arg.rows.0.3, ptr %.353, i64 %.337, i64 %arg.rows.0.6.0, ptr %arg.z.0, ptr %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, ptr %arg.rows.0.0, ptr %arg.rows.0.1, i64 %arg.rows.0.2, i64 %arg.rows.0.3, ptr %arg.rows.0.4, i64 %arg.rows.0.5.0, i64 %arg.rows.0.6.0, ptr %arg.rows.1.0.0, ptr %arg.rows.1.0.1, i64 %arg.rows.1.0.2, i64 %arg.rows.1.0.3, ptr %arg.rows.1.0.4, i64 %arg.rows.1.0.5.0, i64 %arg.rows.1.0.5.1, i64 %arg.rows.1.0.6.0, i64 %arg.rows.1.0.6.1, ptr %arg.rows.1.1.0, ptr %arg.rows.1.1.1, i64 %arg.rows.1.1.2, i64 %arg.rows.1.1.3, ptr %arg.rows.1.1.4, i64 %arg.rows.1.1.5.0, i64 %arg.rows.1.1.6.0, ptr %arg.rows.1.2.0, ptr %arg.rows.1.2.1, i64 %arg.rows.1.2.2, i64 %arg.rows.1.2.3, ptr %arg.rows.1.2.4, i64 %arg.rows.1.2.5.0, i64 %arg.rows.1.2.6.0, ptr %arg.rows.2.0, ptr %arg.rows.2.1, i64 %arg.rows.2.2, i64 %arg.rows.2.3, ptr %arg.rows.2.4, i64 %arg.rows.2.5.0, i64 %arg.rows.2.6.0)
  %cond = icmp eq i32 %.438, 0
  br i1 %cond, label %B0.endif.endif.else, label %B0.endif.if.if, !prof !0

B0.else.endif.if:                                 ; preds = %B0.else
  br label %B0.else.endif.endif

B0.else.endif.endif:                              ; preds = %B0.else.endif.if, %B0.else
  %.240.sroa.0.3 = phi i64 [ %arg.rows.0.5.0, %B0.else.endif.if ], [ 0, %B0.else ]
  %.267 = icmp slt i64 %arg.count, 0
  %.268 = select i1 %.267, i64 %arg.rows.0.5.0, i64 0
  %.269 = add i64 %.268, %arg.count
  %.272 = icmp slt i64 %.269, 0
  br i1 %.272, label %B0.else.endif.endif.if, label %B0.else.endif.endif.endif, !prof !11

B0.else.endif.endif.if:                           ; preds = %B0.else.endif.endif
  br label %B0.else.endif.endif.endif

B0.else.endif.endif.endif:                        ; preds = %B0.else.endif.endif.if, %B0.else.endif.endif
  %.240.sroa.13.1 = phi i64 [ 0, %B0.else.endif.endif.if ], [ %.269, %B0.else.endif.endif ]
  %.277.not = icmp slt i64 %.269, %arg.rows.0.5.0
  br i1 %.277.not, label %B0.endif, label %B0.else.endif.endif.endif.if, !prof !12

B0.else.endif.endif.endif.if:                     ; preds = %B0.else.endif.endif.endif
  br label %B0.endif

common.ret:                                       ; preds = %_ZN18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx.exit, %_ZN18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx.exit.thread, %B0.endif.if.if
  %common.ret.op = phi i32 [ %.438, %B0.endif.if.if ], [ 0, %_ZN18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx.exit.thread ], [ %.119.i, %_ZN18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx.exit ]
  ret i32 %common.ret.op

B0.endif.if.if:                                   ; preds = %B0.endif
  %.446 = icmp sgt i32 %.438, 0
  %.439 = load ptr, ptr %excinfo.1, align 8
  %.447 = select i1 %.446, ptr %.439, ptr undef
  store ptr %.447, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.else:                              ; preds = %B0.endif
  store double 0xFFF0000000000000, ptr %arg.rows.1.1.4, align 8
  %.544 = icmp slt i64 %arg.rows.1.0.5.0, 1
  br i1 %.544, label %B0.endif.endif.else.endif.if, label %B0.endif.endif.else.endif.endif, !prof !11

B0.endif.endif.endif:                             ; preds = %B0.endif.endif.else.endif.endif.endif.if, %B0.endif.endif.else.endif.endif.endif
  %.524.sroa.13.0 = phi i64 [ %.524.sroa.13.1, %B0.endif.endif.else.endif.endif.endif ], [ %arg.rows.1.0.5.0, %B0.endif.endif.else.endif.endif.endif.if ]
  %.612 = sub i64 %.524.sroa.13.0, %.524.sroa.0.3
  %.621 = tail call i64 @llvm.smax.i64(i64 %.612, i64 0)
  %.641 = mul i64 %.524.sroa.0.3, %arg.rows.1.0.5.1
  %.643 = getelementptr double, ptr %arg.rows.1.0.4, i64 %.641
  %.660 = mul nsw i64 %.621, %arg.rows.1.0.5.1
  call void @llvm.lifetime.start.p0(ptr nonnull %.107.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %excinfo.1.i)
  store ptr null, ptr %excinfo.1.i, align 8, !noalias !266
  tail call void @NRT_incref(ptr %arg.rows.1.0.0), !noalias !266
  tail call void @NRT_incref(ptr %arg.rows.1.1.0), !noalias !266
  tail call void @NRT_incref(ptr %arg.rows.1.2.0), !noalias !266
  %.106.i = fdiv double %arg.control.0, %arg.law.3
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.107.i, i8 0, i64 16, i1 false), !noalias !266
  %.119.i = call i32 @_ZN18elastomer_friction7kernels5model7contact17indentation_underB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd(ptr nonnull %.107.i, ptr nonnull %excinfo.1.i, ptr %arg.rows.1.0.0, ptr readnone %arg.rows.1.0.1, i64 %.660, i64 %arg.rows.1.0.3, ptr %.643, i64 %.621, i64 %arg.rows.1.0.5.1, i64 %arg.rows.1.0.6.0, i64 %arg.rows.1.0.6.1, ptr %arg.rows.1.1.0, ptr readnone %arg.rows.1.1.1, i64 %arg.rows.1.1.2, i64 %arg.rows.1.1.3, ptr nonnull %arg.rows.1.1.4, i64 %arg.rows.1.1.5.0, i64 %arg.rows.1.1.6.0, ptr %arg.rows.1.2.0, ptr readnone %arg.rows.1.2.1, i64 %arg.rows.1.2.2, i64 %arg.rows.1.2.3, ptr %arg.rows.1.2.4, i64 %arg.rows.1.2.5.0, i64 %arg.rows.1.2.6.0, double %.106.i, double %arg.old), !noalias !266
  %cond.i = icmp eq i32 %.119.i, 0
  br i1 %cond.i, label %_ZN18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx.exit.thread, label %_ZN18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx.exit, !prof !0

_ZN18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx.exit.thread: ; preds = %B0.endif.endif.endif
  %.fca.1.gep.i = getelementptr inbounds nuw i8, ptr %.107.i, i64 8
  %.129.fca.0.load.i = load double, ptr %.107.i, align 8, !noalias !266
  %.129.fca.1.load.i = load i64, ptr %.fca.1.gep.i, align 8, !noalias !266
  tail call void @NRT_decref(ptr %arg.rows.1.0.0), !noalias !266
  tail call void @NRT_decref(ptr %arg.rows.1.1.0), !noalias !266
  tail call void @NRT_decref(ptr %arg.rows.1.2.0), !noalias !266
  call void @llvm.lifetime.end.p0(ptr nonnull %.107.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.1.i)
  store double %.129.fca.0.load.i, ptr %retptr, align 8
  %retptr.repack95 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store i64 %.129.fca.1.load.i, ptr %retptr.repack95, align 8
  br label %common.ret

_ZN18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx.exit: ; preds = %B0.endif.endif.endif
  %.120.i = load ptr, ptr %excinfo.1.i, align 8, !noalias !266
  call void @llvm.lifetime.end.p0(ptr nonnull %.107.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.1.i)
  %.710 = icmp sgt i32 %.119.i, 0
  %.711 = select i1 %.710, ptr %.120.i, ptr undef
  store ptr %.711, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.else.endif.if:                     ; preds = %B0.endif.endif.else
  br label %B0.endif.endif.else.endif.endif

B0.endif.endif.else.endif.endif:                  ; preds = %B0.endif.endif.else.endif.if, %B0.endif.endif.else
  %.524.sroa.0.3 = phi i64 [ %arg.rows.1.0.5.0, %B0.endif.endif.else.endif.if ], [ 0, %B0.endif.endif.else ]
  %0 = icmp slt i64 %arg.count, 0
  %.552 = select i1 %0, i64 %arg.rows.1.0.5.0, i64 0
  %.553 = add i64 %.552, %arg.count
  %.556 = icmp slt i64 %.553, 0
  br i1 %.556, label %B0.endif.endif.else.endif.endif.if, label %B0.endif.endif.else.endif.endif.endif, !prof !11

B0.endif.endif.else.endif.endif.if:               ; preds = %B0.endif.endif.else.endif.endif
  br label %B0.endif.endif.else.endif.endif.endif

B0.endif.endif.else.endif.endif.endif:            ; preds = %B0.endif.endif.else.endif.endif.if, %B0.endif.endif.else.endif.endif
  %.524.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.else.endif.endif.if ], [ %.553, %B0.endif.endif.else.endif.endif ]
  %.561.not = icmp slt i64 %.553, %arg.rows.1.0.5.0
  br i1 %.561.not, label %B0.endif.endif.endif, label %B0.endif.endif.else.endif.endif.endif.if, !prof !12

B0.endif.endif.else.endif.endif.endif.if:         ; preds = %B0.endif.endif.else.endif.endif.endif
  br label %B0.endif.endif.endif
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.abs.i64(i64, i1 immarg) #10

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define linkonce_odr noundef range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels5scene12march_blocks12press_blocksB3v57B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEd(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.law.0.0, ptr readnone captures(none) %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr readnone captures(none) %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr readnone captures(none) %arg.law.1.0, ptr readnone captures(none) %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr readnone captures(none) %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr readnone captures(none) %arg.law.2.0, ptr readnone captures(none) %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr readnone captures(none) %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr readnone captures(none) %arg.pressed.0, ptr readnone captures(none) %arg.pressed.1, i64 %arg.pressed.2, i64 %arg.pressed.3, ptr captures(none) %arg.pressed.4, i64 %arg.pressed.5.0, i64 %arg.pressed.6.0, ptr readnone captures(none) %arg.new.0, ptr readnone captures(none) %arg.new.1, i64 %arg.new.2, i64 %arg.new.3, ptr writeonly captures(none) %arg.new.4, i64 %arg.new.5.0, i64 %arg.new.5.1, i64 %arg.new.6.0, i64 %arg.new.6.1, ptr readnone captures(none) %arg.some.0, ptr readnone captures(none) %arg.some.1, i64 %arg.some.2, i64 %arg.some.3, ptr readonly captures(none) %arg.some.4, i64 %arg.some.5.0, i64 %arg.some.6.0, ptr readnone captures(none) %arg.c.0, ptr readnone captures(none) %arg.c.1, i64 %arg.c.2, i64 %arg.c.3, ptr readonly captures(none) %arg.c.4, i64 %arg.c.5.0, i64 %arg.c.5.1, i64 %arg.c.6.0, i64 %arg.c.6.1, double %arg.d) local_unnamed_addr #9 {
B0.endif:
  %.179266.not = icmp slt i64 %arg.some.2, 1
  br i1 %.179266.not, label %common.ret, label %B46.endif.endif.preheader

B46.endif.endif.preheader:                        ; preds = %B0.endif
  %arg.new.41 = ptrtoint ptr %arg.new.4 to i64
  %arg.c.42 = ptrtoint ptr %arg.c.4 to i64
  %broadcast.splatinsert3 = insertelement <8 x double> poison, double %arg.law.3, i64 0
  %broadcast.splat4 = shufflevector <8 x double> %broadcast.splatinsert3, <8 x double> poison, <8 x i32> zeroinitializer
  %broadcast.splatinsert = insertelement <8 x double> poison, double %arg.d, i64 0
  %broadcast.splat = shufflevector <8 x double> %broadcast.splatinsert, <8 x double> poison, <8 x i32> zeroinitializer
  %0 = sub i64 %arg.new.41, %arg.c.42
  %scevgep = getelementptr i8, ptr %arg.new.4, i64 56
  %1 = shl i64 %arg.new.5.1, 3
  %scevgep17 = getelementptr i8, ptr %arg.c.4, i64 56
  %2 = shl i64 %arg.c.5.1, 3
  br label %B46.endif.endif

B110:                                             ; preds = %B110.preheader, %B110
  %touching.2.1260 = phi i64 [ %.525.7, %B110 ], [ 0, %B110.preheader ]
  %.342256258 = phi i64 [ %.349.7, %B110 ], [ 0, %B110.preheader ]
  %3 = shl nuw nsw i64 %.342256258, 3
  %scevgep30 = getelementptr i8, ptr %lsr.iv, i64 %3
  %scevgep31 = getelementptr i8, ptr %scevgep30, i64 -56
  %.428 = load double, ptr %scevgep31, align 8
  %.430 = fsub double %arg.d, %.428
  %.435 = fcmp ogt double %.430, 0.000000e+00
  %.440 = fmul double %arg.law.3, %.430
  %.440.sink = select i1 %.435, double %.440, double 0.000000e+00
  %"$phi204.3.2.2" = zext i1 %.435 to i64
  %4 = shl nuw nsw i64 %.342256258, 3
  %scevgep13 = getelementptr i8, ptr %scevgep1, i64 %4
  %scevgep14 = getelementptr i8, ptr %scevgep13, i64 -56
  store double %.440.sink, ptr %scevgep14, align 8
  %.525 = add nuw nsw i64 %touching.2.1260, %"$phi204.3.2.2"
  %5 = shl nuw nsw i64 %.342256258, 3
  %scevgep32 = getelementptr i8, ptr %lsr.iv, i64 %5
  %scevgep33 = getelementptr i8, ptr %scevgep32, i64 -48
  %.428.1 = load double, ptr %scevgep33, align 8
  %.430.1 = fsub double %arg.d, %.428.1
  %.435.1 = fcmp ogt double %.430.1, 0.000000e+00
  %.440.1 = fmul double %arg.law.3, %.430.1
  %.440.sink.1 = select i1 %.435.1, double %.440.1, double 0.000000e+00
  %"$phi204.3.2.2.1" = zext i1 %.435.1 to i64
  %6 = shl nuw nsw i64 %.342256258, 3
  %scevgep15 = getelementptr i8, ptr %scevgep1, i64 %6
  %scevgep16 = getelementptr i8, ptr %scevgep15, i64 -48
  store double %.440.sink.1, ptr %scevgep16, align 8
  %.525.1 = add nuw nsw i64 %.525, %"$phi204.3.2.2.1"
  %7 = shl nuw nsw i64 %.342256258, 3
  %scevgep28 = getelementptr i8, ptr %lsr.iv, i64 %7
  %scevgep29 = getelementptr i8, ptr %scevgep28, i64 -40
  %.428.2 = load double, ptr %scevgep29, align 8
  %.430.2 = fsub double %arg.d, %.428.2
  %.435.2 = fcmp ogt double %.430.2, 0.000000e+00
  %.440.2 = fmul double %arg.law.3, %.430.2
  %.440.sink.2 = select i1 %.435.2, double %.440.2, double 0.000000e+00
  %"$phi204.3.2.2.2" = zext i1 %.435.2 to i64
  %8 = shl nuw nsw i64 %.342256258, 3
  %scevgep11 = getelementptr i8, ptr %scevgep1, i64 %8
  %scevgep12 = getelementptr i8, ptr %scevgep11, i64 -40
  store double %.440.sink.2, ptr %scevgep12, align 8
  %.525.2 = add nuw nsw i64 %.525.1, %"$phi204.3.2.2.2"
  %9 = shl nuw nsw i64 %.342256258, 3
  %scevgep26 = getelementptr i8, ptr %lsr.iv, i64 %9
  %scevgep27 = getelementptr i8, ptr %scevgep26, i64 -32
  %.428.3 = load double, ptr %scevgep27, align 8
  %.430.3 = fsub double %arg.d, %.428.3
  %.435.3 = fcmp ogt double %.430.3, 0.000000e+00
  %.440.3 = fmul double %arg.law.3, %.430.3
  %.440.sink.3 = select i1 %.435.3, double %.440.3, double 0.000000e+00
  %"$phi204.3.2.2.3" = zext i1 %.435.3 to i64
  %10 = shl nuw nsw i64 %.342256258, 3
  %scevgep9 = getelementptr i8, ptr %scevgep1, i64 %10
  %scevgep10 = getelementptr i8, ptr %scevgep9, i64 -32
  store double %.440.sink.3, ptr %scevgep10, align 8
  %.525.3 = add nuw nsw i64 %.525.2, %"$phi204.3.2.2.3"
  %11 = shl nuw nsw i64 %.342256258, 3
  %scevgep24 = getelementptr i8, ptr %lsr.iv, i64 %11
  %scevgep25 = getelementptr i8, ptr %scevgep24, i64 -24
  %.428.4 = load double, ptr %scevgep25, align 8
  %.430.4 = fsub double %arg.d, %.428.4
  %.435.4 = fcmp ogt double %.430.4, 0.000000e+00
  %.440.4 = fmul double %arg.law.3, %.430.4
  %.440.sink.4 = select i1 %.435.4, double %.440.4, double 0.000000e+00
  %"$phi204.3.2.2.4" = zext i1 %.435.4 to i64
  %12 = shl nuw nsw i64 %.342256258, 3
  %scevgep7 = getelementptr i8, ptr %scevgep1, i64 %12
  %scevgep8 = getelementptr i8, ptr %scevgep7, i64 -24
  store double %.440.sink.4, ptr %scevgep8, align 8
  %.525.4 = add nuw nsw i64 %.525.3, %"$phi204.3.2.2.4"
  %13 = shl nuw nsw i64 %.342256258, 3
  %scevgep22 = getelementptr i8, ptr %lsr.iv, i64 %13
  %scevgep23 = getelementptr i8, ptr %scevgep22, i64 -16
  %.428.5 = load double, ptr %scevgep23, align 8
  %.430.5 = fsub double %arg.d, %.428.5
  %.435.5 = fcmp ogt double %.430.5, 0.000000e+00
  %.440.5 = fmul double %arg.law.3, %.430.5
  %.440.sink.5 = select i1 %.435.5, double %.440.5, double 0.000000e+00
  %"$phi204.3.2.2.5" = zext i1 %.435.5 to i64
  %14 = shl nuw nsw i64 %.342256258, 3
  %scevgep5 = getelementptr i8, ptr %scevgep1, i64 %14
  %scevgep6 = getelementptr i8, ptr %scevgep5, i64 -16
  store double %.440.sink.5, ptr %scevgep6, align 8
  %.525.5 = add nuw nsw i64 %.525.4, %"$phi204.3.2.2.5"
  %15 = shl nuw nsw i64 %.342256258, 3
  %scevgep20 = getelementptr i8, ptr %lsr.iv, i64 %15
  %scevgep21 = getelementptr i8, ptr %scevgep20, i64 -8
  %.428.6 = load double, ptr %scevgep21, align 8
  %.430.6 = fsub double %arg.d, %.428.6
  %.435.6 = fcmp ogt double %.430.6, 0.000000e+00
  %.440.6 = fmul double %arg.law.3, %.430.6
  %.440.sink.6 = select i1 %.435.6, double %.440.6, double 0.000000e+00
  %"$phi204.3.2.2.6" = zext i1 %.435.6 to i64
  %16 = shl nuw nsw i64 %.342256258, 3
  %scevgep3 = getelementptr i8, ptr %scevgep1, i64 %16
  %scevgep4 = getelementptr i8, ptr %scevgep3, i64 -8
  store double %.440.sink.6, ptr %scevgep4, align 8
  %.525.6 = add nuw nsw i64 %.525.5, %"$phi204.3.2.2.6"
  %.349.7 = add nuw nsw i64 %.342256258, 8
  %17 = shl nuw nsw i64 %.342256258, 3
  %scevgep19 = getelementptr i8, ptr %lsr.iv, i64 %17
  %.428.7 = load double, ptr %scevgep19, align 8
  %.430.7 = fsub double %arg.d, %.428.7
  %.435.7 = fcmp ogt double %.430.7, 0.000000e+00
  %.440.7 = fmul double %arg.law.3, %.430.7
  %.440.sink.7 = select i1 %.435.7, double %.440.7, double 0.000000e+00
  %"$phi204.3.2.2.7" = zext i1 %.435.7 to i64
  %18 = shl nuw nsw i64 %.342256258, 3
  %scevgep2 = getelementptr i8, ptr %scevgep1, i64 %18
  store double %.440.sink.7, ptr %scevgep2, align 8
  %.525.7 = add nuw nsw i64 %.525.6, %"$phi204.3.2.2.7"
  %exitcond.not.7 = icmp eq i64 %.349.7, 64
  br i1 %exitcond.not.7, label %B212, label %B110, !llvm.loop !270

B212:                                             ; preds = %B110, %vector.body
  %.525.lcssa = phi i64 [ %70, %vector.body ], [ %.525.7, %B110 ]
  %19 = icmp slt i64 %.250, 0
  %.192 = add nuw nsw i64 %.185262267, 1
  %.540.not = icmp eq i64 %.525.lcssa, 0
  %.563 = select i1 %19, i64 %arg.pressed.5.0, i64 0
  br i1 %.540.not, label %B228, label %B276

B228:                                             ; preds = %B212
  %20 = getelementptr i64, ptr %arg.pressed.4, i64 %.250
  %.577 = getelementptr i64, ptr %20, i64 %.563
  %.578 = load i64, ptr %.577, align 8
  %21 = tail call i64 @llvm.smax.i64(i64 %.578, i64 1)
  %.11.i = add nsw i64 %21, -1
  br label %B276

B276:                                             ; preds = %B228, %B212
  %"$phi276.1.2.1" = phi i64 [ 2, %B212 ], [ %.11.i, %B228 ]
  %22 = getelementptr i64, ptr %arg.pressed.4, i64 %.250
  %.641 = getelementptr i64, ptr %22, i64 %.563
  store i64 %"$phi276.1.2.1", ptr %.641, align 8
  %scevgep18 = getelementptr i8, ptr %lsr.iv, i64 %2
  %exitcond274.not = icmp eq i64 %arg.some.2, %.192
  br i1 %exitcond274.not, label %common.ret, label %B46.endif.endif

common.ret:                                       ; preds = %B276, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B46.endif.endif:                                  ; preds = %B276, %B46.endif.endif.preheader
  %lsr.iv = phi ptr [ %scevgep18, %B276 ], [ %scevgep17, %B46.endif.endif.preheader ]
  %.185262267 = phi i64 [ %.192, %B276 ], [ 0, %B46.endif.endif.preheader ]
  %23 = getelementptr i64, ptr %arg.some.4, i64 %.185262267
  %.250 = load i64, ptr %23, align 8
  %.423 = mul i64 %.185262267, %arg.c.5.1
  %.475.c = icmp slt i64 %.250, 0
  %.476.c = select i1 %.475.c, i64 %arg.new.5.0, i64 0
  %.477.c = add i64 %.476.c, %.250
  %.497.c = mul i64 %.477.c, %arg.new.5.1
  %reass.add = sub i64 %.497.c, %.423
  %reass.mul = shl i64 %reass.add, 3
  %24 = add i64 %0, %reass.mul
  %diff.check = icmp ult i64 %24, 256
  br i1 %diff.check, label %B110.preheader, label %vector.body

B110.preheader:                                   ; preds = %B46.endif.endif
  %25 = mul i64 %1, %.477.c
  %scevgep1 = getelementptr i8, ptr %scevgep, i64 %25
  br label %B110

vector.body:                                      ; preds = %B46.endif.endif
  %sunkaddr = mul i64 %.423, 8
  %sunkaddr39 = getelementptr i8, ptr %arg.c.4, i64 %sunkaddr
  %wide.load = load <8 x double>, ptr %sunkaddr39, align 8
  %sunkaddr40 = mul i64 %.423, 8
  %sunkaddr41 = getelementptr i8, ptr %arg.c.4, i64 %sunkaddr40
  %sunkaddr42 = getelementptr i8, ptr %sunkaddr41, i64 64
  %wide.load8 = load <8 x double>, ptr %sunkaddr42, align 8
  %sunkaddr43 = mul i64 %.423, 8
  %sunkaddr44 = getelementptr i8, ptr %arg.c.4, i64 %sunkaddr43
  %sunkaddr45 = getelementptr i8, ptr %sunkaddr44, i64 128
  %wide.load9 = load <8 x double>, ptr %sunkaddr45, align 8
  %sunkaddr46 = mul i64 %.423, 8
  %sunkaddr47 = getelementptr i8, ptr %arg.c.4, i64 %sunkaddr46
  %sunkaddr48 = getelementptr i8, ptr %sunkaddr47, i64 192
  %wide.load10 = load <8 x double>, ptr %sunkaddr48, align 8
  %26 = fsub <8 x double> %broadcast.splat, %wide.load
  %27 = fsub <8 x double> %broadcast.splat, %wide.load8
  %28 = fsub <8 x double> %broadcast.splat, %wide.load9
  %29 = fsub <8 x double> %broadcast.splat, %wide.load10
  %30 = fcmp ogt <8 x double> %26, zeroinitializer
  %31 = fcmp ogt <8 x double> %27, zeroinitializer
  %32 = fcmp ogt <8 x double> %28, zeroinitializer
  %33 = fcmp ogt <8 x double> %29, zeroinitializer
  %34 = fmul <8 x double> %broadcast.splat4, %26
  %35 = fmul <8 x double> %broadcast.splat4, %27
  %36 = fmul <8 x double> %broadcast.splat4, %28
  %37 = fmul <8 x double> %broadcast.splat4, %29
  %38 = select <8 x i1> %30, <8 x double> %34, <8 x double> zeroinitializer
  %39 = select <8 x i1> %31, <8 x double> %35, <8 x double> zeroinitializer
  %40 = select <8 x i1> %32, <8 x double> %36, <8 x double> zeroinitializer
  %41 = select <8 x i1> %33, <8 x double> %37, <8 x double> zeroinitializer
  %42 = zext <8 x i1> %30 to <8 x i64>
  %43 = zext <8 x i1> %31 to <8 x i64>
  %44 = zext <8 x i1> %32 to <8 x i64>
  %45 = zext <8 x i1> %33 to <8 x i64>
  %sunkaddr49 = mul i64 %.497.c, 8
  %sunkaddr50 = getelementptr i8, ptr %arg.new.4, i64 %sunkaddr49
  store <8 x double> %38, ptr %sunkaddr50, align 8
  %sunkaddr51 = mul i64 %.497.c, 8
  %sunkaddr52 = getelementptr i8, ptr %arg.new.4, i64 %sunkaddr51
  %sunkaddr53 = getelementptr i8, ptr %sunkaddr52, i64 64
  store <8 x double> %39, ptr %sunkaddr53, align 8
  %sunkaddr54 = mul i64 %.497.c, 8
  %sunkaddr55 = getelementptr i8, ptr %arg.new.4, i64 %sunkaddr54
  %sunkaddr56 = getelementptr i8, ptr %sunkaddr55, i64 128
  store <8 x double> %40, ptr %sunkaddr56, align 8
  %sunkaddr57 = mul i64 %.497.c, 8
  %sunkaddr58 = getelementptr i8, ptr %arg.new.4, i64 %sunkaddr57
  %sunkaddr59 = getelementptr i8, ptr %sunkaddr58, i64 192
  store <8 x double> %41, ptr %sunkaddr59, align 8
  %sunkaddr60 = mul i64 %.423, 8
  %sunkaddr61 = getelementptr i8, ptr %arg.c.4, i64 %sunkaddr60
  %sunkaddr62 = getelementptr i8, ptr %sunkaddr61, i64 256
  %wide.load.1 = load <8 x double>, ptr %sunkaddr62, align 8
  %sunkaddr63 = mul i64 %.423, 8
  %sunkaddr64 = getelementptr i8, ptr %arg.c.4, i64 %sunkaddr63
  %sunkaddr65 = getelementptr i8, ptr %sunkaddr64, i64 320
  %wide.load8.1 = load <8 x double>, ptr %sunkaddr65, align 8
  %sunkaddr66 = mul i64 %.423, 8
  %sunkaddr67 = getelementptr i8, ptr %arg.c.4, i64 %sunkaddr66
  %sunkaddr68 = getelementptr i8, ptr %sunkaddr67, i64 384
  %wide.load9.1 = load <8 x double>, ptr %sunkaddr68, align 8
  %sunkaddr69 = mul i64 %.423, 8
  %sunkaddr70 = getelementptr i8, ptr %arg.c.4, i64 %sunkaddr69
  %sunkaddr71 = getelementptr i8, ptr %sunkaddr70, i64 448
  %wide.load10.1 = load <8 x double>, ptr %sunkaddr71, align 8
  %46 = fsub <8 x double> %broadcast.splat, %wide.load.1
  %47 = fsub <8 x double> %broadcast.splat, %wide.load8.1
  %48 = fsub <8 x double> %broadcast.splat, %wide.load9.1
  %49 = fsub <8 x double> %broadcast.splat, %wide.load10.1
  %50 = fcmp ogt <8 x double> %46, zeroinitializer
  %51 = fcmp ogt <8 x double> %47, zeroinitializer
  %52 = fcmp ogt <8 x double> %48, zeroinitializer
  %53 = fcmp ogt <8 x double> %49, zeroinitializer
  %54 = fmul <8 x double> %broadcast.splat4, %46
  %55 = fmul <8 x double> %broadcast.splat4, %47
  %56 = fmul <8 x double> %broadcast.splat4, %48
  %57 = fmul <8 x double> %broadcast.splat4, %49
  %58 = select <8 x i1> %50, <8 x double> %54, <8 x double> zeroinitializer
  %59 = select <8 x i1> %51, <8 x double> %55, <8 x double> zeroinitializer
  %60 = select <8 x i1> %52, <8 x double> %56, <8 x double> zeroinitializer
  %61 = select <8 x i1> %53, <8 x double> %57, <8 x double> zeroinitializer
  %62 = zext <8 x i1> %50 to <8 x i64>
  %63 = zext <8 x i1> %51 to <8 x i64>
  %64 = zext <8 x i1> %52 to <8 x i64>
  %65 = zext <8 x i1> %53 to <8 x i64>
  %sunkaddr72 = mul i64 %.497.c, 8
  %sunkaddr73 = getelementptr i8, ptr %arg.new.4, i64 %sunkaddr72
  %sunkaddr74 = getelementptr i8, ptr %sunkaddr73, i64 256
  store <8 x double> %58, ptr %sunkaddr74, align 8
  %sunkaddr75 = mul i64 %.497.c, 8
  %sunkaddr76 = getelementptr i8, ptr %arg.new.4, i64 %sunkaddr75
  %sunkaddr77 = getelementptr i8, ptr %sunkaddr76, i64 320
  store <8 x double> %59, ptr %sunkaddr77, align 8
  %sunkaddr78 = mul i64 %.497.c, 8
  %sunkaddr79 = getelementptr i8, ptr %arg.new.4, i64 %sunkaddr78
  %sunkaddr80 = getelementptr i8, ptr %sunkaddr79, i64 384
  store <8 x double> %60, ptr %sunkaddr80, align 8
  %sunkaddr81 = mul i64 %.497.c, 8
  %sunkaddr82 = getelementptr i8, ptr %arg.new.4, i64 %sunkaddr81
  %sunkaddr83 = getelementptr i8, ptr %sunkaddr82, i64 448
  store <8 x double> %61, ptr %sunkaddr83, align 8
  %66 = add nuw nsw <8 x i64> %43, %42
  %67 = add nuw nsw <8 x i64> %66, %44
  %bin.rdx = add nuw nsw <8 x i64> %67, %45
  %68 = add nuw nsw <8 x i64> %bin.rdx, %62
  %bin.rdx11 = add nuw nsw <8 x i64> %68, %63
  %69 = add nuw nsw <8 x i64> %bin.rdx11, %64
  %bin.rdx12 = add nuw nsw <8 x i64> %69, %65
  %rdx.shuf = shufflevector <8 x i64> %bin.rdx12, <8 x i64> poison, <8 x i32> <i32 4, i32 5, i32 6, i32 7, i32 poison, i32 poison, i32 poison, i32 poison>
  %bin.rdx34 = add <8 x i64> %bin.rdx12, %rdx.shuf
  %rdx.shuf35 = shufflevector <8 x i64> %bin.rdx34, <8 x i64> poison, <8 x i32> <i32 2, i32 3, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison>
  %bin.rdx36 = add <8 x i64> %bin.rdx34, %rdx.shuf35
  %rdx.shuf37 = shufflevector <8 x i64> %bin.rdx36, <8 x i64> poison, <8 x i32> <i32 1, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison>
  %bin.rdx38 = add <8 x i64> %bin.rdx36, %rdx.shuf37
  %70 = extractelement <8 x i64> %bin.rdx38, i32 0
  br label %B212
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.vector.reduce.add.v8i64(<8 x i64>) #10

; Function Attrs: nofree norecurse nosync nounwind memory(write, argmem: readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define linkonce_odr range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels5scene12march_blocks8_predictB3v41B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE213Rows_28array_28int64_2c_201d_2c_20C_29_2c_20SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_29(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, ptr readnone captures(none) %arg.law.0.0, ptr readnone captures(none) %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr readnone captures(none) %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr readnone captures(none) %arg.law.1.0, ptr readnone captures(none) %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr readnone captures(none) %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr readnone captures(none) %arg.law.2.0, ptr readnone captures(none) %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr readonly captures(none) %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr readnone captures(none) %arg.blocks.0.0, ptr readnone captures(none) %arg.blocks.0.1, i64 %arg.blocks.0.2, i64 %arg.blocks.0.3, ptr captures(address) %arg.blocks.0.4, i64 %arg.blocks.0.5.0, i64 %arg.blocks.0.5.1, i64 %arg.blocks.0.5.2, i64 %arg.blocks.0.6.0, i64 %arg.blocks.0.6.1, i64 %arg.blocks.0.6.2, ptr readnone captures(none) %arg.blocks.1.0, ptr readnone captures(none) %arg.blocks.1.1, i64 %arg.blocks.1.2, i64 %arg.blocks.1.3, ptr captures(none) %arg.blocks.1.4, i64 %arg.blocks.1.5.0, i64 %arg.blocks.1.6.0, ptr readnone captures(none) %arg.blocks.2.0, ptr readnone captures(none) %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr readonly captures(none) %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0, ptr readnone captures(none) %arg.blocks.3.0.0, ptr readnone captures(none) %arg.blocks.3.0.1, i64 %arg.blocks.3.0.2, i64 %arg.blocks.3.0.3, ptr readnone captures(none) %arg.blocks.3.0.4, i64 %arg.blocks.3.0.5.0, i64 %arg.blocks.3.0.6.0, ptr readnone captures(none) %arg.blocks.3.1.0, ptr readnone captures(none) %arg.blocks.3.1.1, i64 %arg.blocks.3.1.2, i64 %arg.blocks.3.1.3, ptr readonly captures(none) %arg.blocks.3.1.4, i64 %arg.blocks.3.1.5.0, i64 %arg.blocks.3.1.6.0, ptr readnone captures(none) %arg.blocks.3.2.0, ptr readnone captures(none) %arg.blocks.3.2.1, i64 %arg.blocks.3.2.2, i64 %arg.blocks.3.2.3, ptr readonly captures(none) %arg.blocks.3.2.4, i64 %arg.blocks.3.2.5.0, i64 %arg.blocks.3.2.6.0, ptr readnone captures(none) %arg.blocks.3.3.0, ptr readnone captures(none) %arg.blocks.3.3.1, i64 %arg.blocks.3.3.2, i64 %arg.blocks.3.3.3, ptr %arg.blocks.3.3.4, i64 %arg.blocks.3.3.5.0, i64 %arg.blocks.3.3.6.0, ptr readnone captures(none) %arg.blocks.3.4.0, ptr readnone captures(none) %arg.blocks.3.4.1, i64 %arg.blocks.3.4.2, i64 %arg.blocks.3.4.3, ptr %arg.blocks.3.4.4, i64 %arg.blocks.3.4.5.0, i64 %arg.blocks.3.4.6.0, ptr readnone captures(none) %arg.blocks.3.5.0, ptr readnone captures(none) %arg.blocks.3.5.1, i64 %arg.blocks.3.5.2, i64 %arg.blocks.3.5.3, ptr readonly captures(none) %arg.blocks.3.5.4, i64 %arg.blocks.3.5.5.0, i64 %arg.blocks.3.5.6.0, ptr readnone captures(none) %arg.p.0, ptr readnone captures(none) %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr readonly captures(none) %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1, ptr readnone captures(none) %arg.older.0, ptr readnone captures(none) %arg.older.1, i64 %arg.older.2, i64 %arg.older.3, ptr readonly captures(none) %arg.older.4, i64 %arg.older.5.0, i64 %arg.older.5.1, i64 %arg.older.6.0, i64 %arg.older.6.1, i64 %arg.step, ptr readnone captures(none) %arg.some.0, ptr readnone captures(none) %arg.some.1, i64 %arg.some.2, i64 %arg.some.3, ptr readonly captures(none) %arg.some.4, i64 %arg.some.5.0, i64 %arg.some.6.0, ptr readnone captures(none) %arg.z.0, ptr readnone captures(none) %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr readonly captures(none) %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, ptr readnone captures(none) %arg.rows.0.0, ptr readnone captures(none) %arg.rows.0.1, i64 %arg.rows.0.2, i64 %arg.rows.0.3, ptr readnone captures(none) %arg.rows.0.4, i64 %arg.rows.0.5.0, i64 %arg.rows.0.6.0, ptr readnone captures(none) %arg.rows.1.0.0, ptr readnone captures(none) %arg.rows.1.0.1, i64 %arg.rows.1.0.2, i64 %arg.rows.1.0.3, ptr writeonly captures(none) %arg.rows.1.0.4, i64 %arg.rows.1.0.5.0, i64 %arg.rows.1.0.5.1, i64 %arg.rows.1.0.6.0, i64 %arg.rows.1.0.6.1, ptr readnone captures(none) %arg.rows.1.1.0, ptr readnone captures(none) %arg.rows.1.1.1, i64 %arg.rows.1.1.2, i64 %arg.rows.1.1.3, ptr readnone captures(none) %arg.rows.1.1.4, i64 %arg.rows.1.1.5.0, i64 %arg.rows.1.1.6.0, ptr readnone captures(none) %arg.rows.1.2.0, ptr readnone captures(none) %arg.rows.1.2.1, i64 %arg.rows.1.2.2, i64 %arg.rows.1.2.3, ptr readnone captures(none) %arg.rows.1.2.4, i64 %arg.rows.1.2.5.0, i64 %arg.rows.1.2.6.0, ptr readnone captures(none) %arg.rows.2.0, ptr readnone captures(none) %arg.rows.2.1, i64 %arg.rows.2.2, i64 %arg.rows.2.3, ptr captures(address) %arg.rows.2.4, i64 %arg.rows.2.5.0, i64 %arg.rows.2.6.0) local_unnamed_addr #11 {
B0:
  %.221 = alloca ptr, align 8
  %excinfo.1 = alloca ptr, align 8
  %.276 = alloca ptr, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.247 = call i32 @_ZN18elastomer_friction7kernels8rheology6scaled8catch_upB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx(ptr nonnull %.221, ptr nonnull %excinfo.1, ptr %arg.blocks.3.0.0, ptr %arg.blocks.3.0.1, i64 %arg.blocks.3.0.2, i64 %arg.blocks.3.0.3, ptr %arg.blocks.3.0.4, i64 %arg.blocks.3.0.5.0, i64 %arg.blocks.3.0.6.0, ptr %arg.blocks.3.1.0, ptr %arg.blocks.3.1.1, i64 %arg.blocks.3.1.2, i64 %arg.blocks.3.1.3, ptr %arg.blocks.3.1.4, i64 %arg.blocks.3.1.5.0, i64 %arg.blocks.3.1.6.0, ptr %arg.blocks.3.2.0, ptr %arg.blocks.3.2.1, i64 %arg.blocks.3.2.2, i64 %arg.blocks.3.2.3, ptr %arg.blocks.3.2.4, i64 %arg.blocks.3.2.5.0, i64 %arg.blocks.3.2.6.0, ptr %arg.blocks.3.3.0, ptr %arg.blocks.3.3.1, i64 %arg.blocks.3.3.2, i64 %arg.blocks.3.3.3, ptr %arg.blocks.3.3.4, i64 %arg.blocks.3.3.5.0, i64 %arg.blocks.3.3.6.0, ptr %arg.blocks.3.4.0, ptr %arg.blocks.3.4.1, i64 %arg.blocks.3.4.2, i64 %arg.blocks.3.4.3, ptr %arg.blocks.3.4.4, i64 %arg.blocks.3.4.5.0, i64 %arg.blocks.3.4.6.0, ptr %arg.blocks.3.5.0, ptr %arg.blocks.3.5.1, i64 %arg.blocks.3.5.2, i64 %arg.blocks.3.5.3, ptr %arg.blocks.3.5.4, i64 %arg.blocks.3.5.5.0, i64 %arg.blocks.3.5.6.0, ptr %arg.blocks.0.0, ptr %arg.blocks.0.1, i64 %arg.blocks.0.2, i64 %arg.blocks.0.3, ptr %arg.blocks.0.4, i64 %arg.blocks.0.5.0, i64 %arg.blocks.0.5.1, i64 %arg.blocks.0.5.2, i64 %arg.blocks.0.6.0, i64 %arg.blocks.0.6.1, i64 %arg.blocks.0.6.2, ptr %arg.blocks.1.0, ptr %arg.blocks.1.1, i64 %arg.blocks.1.2, i64 %arg.blocks.1.3, ptr %arg.blocks.1.4, i64 %arg.blocks.1.5.0, i64 %arg.blocks.1.6.0, ptr %arg.some.0, ptr %arg.some.1, i64 %arg.some.2, i64 %arg.some.3, ptr %arg.some.4, i64 %arg.some.5.0, i64 %arg.some.6.0, i64 %arg.step)
  %cond = icmp eq i32 %.247, 0
  br i1 %cond, label %B0.endif, label %B0.if.if, !prof !0

B0.endif:                                         ; preds = %B0
  %.324 = call i32 @_ZN18elastomer_friction7kernels8rheology6scaled18settle_and_predictB3v44B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE(ptr nonnull %.276, ptr nonnull %excinfo.2, ptr %arg.law.0.0, ptr %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr %arg.law.1.0, ptr %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr %arg.law.2.0, ptr %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr %arg.blocks.3.0.0, ptr %arg.blocks.3.0.1, i64 %arg.blocks.3.0.2, i64 %arg.blocks.3.0.3, ptr %arg.blocks.3.0.4, i64 %arg.blocks.3.0.5.0, i64 %arg.blocks.3.0.6.0, ptr %arg.blocks.3.1.0, ptr %arg.blocks.3.1.1, i64 %arg.blocks.3.1.2, i64 %arg.blocks.3.1.3, ptr %arg.blocks.3.1.4, i64 %arg.blocks.3.1.5.0, i64 %arg.blocks.3.1.6.0, ptr %arg.blocks.3.2.0, ptr %arg.blocks.3.2.1, i64 %arg.blocks.3.2.2, i64 %arg.blocks.3.2.3, ptr %arg.blocks.3.2.4, i64 %arg.blocks.3.2.5.0, i64 %arg.blocks.3.2.6.0, ptr %arg.blocks.3.3.0, ptr %arg.blocks.3.3.1, i64 %arg.blocks.3.3.2, i64 %arg.blocks.3.3.3, ptr %arg.blocks.3.3.4, i64 %arg.blocks.3.3.5.0, i64 %arg.blocks.3.3.6.0, ptr %arg.blocks.3.4.0, ptr %arg.blocks.3.4.1, i64 %arg.blocks.3.4.2, i64 %arg.blocks.3.4.3, ptr %arg.blocks.3.4.4, i64 %arg.blocks.3.4.5.0, i64 %arg.blocks.3.4.6.0, ptr %arg.blocks.3.5.0, ptr %arg.blocks.3.5.1, i64 %arg.blocks.3.5.2, i64 %arg.blocks.3.5.3, ptr %arg.blocks.3.5.4, i64 %arg.blocks.3.5.5.0, i64 %arg.blocks.3.5.6.0, ptr %arg.blocks.0.0, ptr %arg.blocks.0.1, i64 %arg.blocks.0.2, i64 %arg.blocks.0.3, ptr %arg.blocks.0.4, i64 %arg.blocks.0.5.0, i64 %arg.blocks.0.5.1, i64 %arg.blocks.0.5.2, i64 %arg.blocks.0.6.0, i64 %arg.blocks.0.6.1, i64 %arg.blocks.0.6.2, ptr %arg.blocks.2.0, ptr %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0, ptr %arg.p.0, ptr %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1, ptr %arg.older.0, ptr %arg.older.1, i64 %arg.older.2, i64 %arg.older.3, ptr %arg.older.4, i64 %arg.older.5.0, i64 %arg.older.5.1, i64 %arg.older.6.0, i64 %arg.older.6.1, ptr %arg.some.0, ptr %arg.some.1, i64 %arg.some.2, i64 %arg.some.3, ptr %arg.some.4, i64 %arg.some.5.0, i64 %arg.some.6.0, ptr %arg.z.0, ptr %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, ptr %arg.rows.2.0, ptr %arg.rows.2.1, i64 %arg.rows.2.2, i64 %arg.rows.2.3, ptr %arg.rows.2.4, i64 %arg.rows.2.5.0, i64 %arg.rows.2.6.0, ptr %arg.rows.1.0.0, ptr %arg.rows.1.0.1, i64 %arg.rows.1.0.2, i64 %arg.rows.1.0.3, ptr %arg.rows.1.0.4, i64 %arg.rows.1.0.5.0, i64 %arg.rows.1.0.5.1, i64 %arg.rows.1.0.6.0, i64 %arg.rows.1.0.6.1)
  %cond1 = icmp eq i32 %.324, 0
  br i1 %cond1, label %B0.endif.endif, label %B0.endif.if.if, !prof !0

common.ret:                                       ; preds = %B0.endif.endif.endif, %B0.endif.if.if, %B0.if.if
  %common.ret.op = phi i32 [ %.247, %B0.if.if ], [ %.324, %B0.endif.if.if ], [ 0, %B0.endif.endif.endif ]
  ret i32 %common.ret.op

B0.if.if:                                         ; preds = %B0
  store ptr null, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif:                                   ; preds = %B0.endif
  %.149179.not.i = icmp slt i64 %arg.blocks.3.3.2, 1
  br i1 %.149179.not.i, label %B0.endif.endif.endif, label %iter.check.i

iter.check.i:                                     ; preds = %B0.endif.endif
  %arg.scales.4.41.i = ptrtoint ptr %arg.blocks.3.4.4 to i64
  %arg.scales.3.42.i = ptrtoint ptr %arg.blocks.3.3.4 to i64
  %min.iters.check.i = icmp samesign ult i64 %arg.blocks.3.3.2, 4
  %0 = sub i64 %arg.scales.4.41.i, %arg.scales.3.42.i
  %diff.check.i = icmp ult i64 %0, 256
  %or.cond.i = select i1 %min.iters.check.i, i1 true, i1 %diff.check.i
  br i1 %or.cond.i, label %B56.preheader.i, label %vector.main.loop.iter.check.i

vector.main.loop.iter.check.i:                    ; preds = %iter.check.i
  %const = bitcast i64 9223372036854775776 to i64
  %min.iters.check3.i = icmp samesign ult i64 %arg.blocks.3.3.2, 32
  br i1 %min.iters.check3.i, label %vec.epilog.ph.i, label %vector.ph.i

vector.ph.i:                                      ; preds = %vector.main.loop.iter.check.i
  %n.vec.i = and i64 %arg.blocks.3.3.2, %const
  br label %vector.body.i

vector.body.i:                                    ; preds = %vector.body.i, %vector.ph.i
  %index.i = phi i64 [ 0, %vector.ph.i ], [ %index.next.i, %vector.body.i ]
  %1 = shl i64 %index.i, 3
  %scevgep37 = getelementptr i8, ptr %arg.blocks.3.3.4, i64 %1
  %2 = shl i64 %index.i, 3
  %scevgep36 = getelementptr i8, ptr %arg.blocks.3.4.4, i64 %2
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(256) %scevgep37, i8 0, i64 256, i1 false), !noalias !271
  %index.next.i = add nuw nsw i64 %index.i, 32
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(256) %scevgep36, i8 0, i64 256, i1 false), !noalias !271
  %3 = icmp eq i64 %n.vec.i, %index.next.i
  br i1 %3, label %middle.block.i, label %vector.body.i, !llvm.loop !274

middle.block.i:                                   ; preds = %vector.body.i
  %cmp.n.i = icmp eq i64 %arg.blocks.3.3.2, %n.vec.i
  br i1 %cmp.n.i, label %B0.endif.endif.endif, label %vec.epilog.iter.check.i

vec.epilog.iter.check.i:                          ; preds = %middle.block.i
  %n.mod.vf.i = and i64 %arg.blocks.3.3.2, 28
  %min.epilog.iters.check.i = icmp eq i64 %n.mod.vf.i, 0
  br i1 %min.epilog.iters.check.i, label %B56.preheader.i, label %vec.epilog.ph.i, !prof !91

vec.epilog.ph.i:                                  ; preds = %vec.epilog.iter.check.i, %vector.main.loop.iter.check.i
  %vec.epilog.resume.val.i = phi i64 [ %n.vec.i, %vec.epilog.iter.check.i ], [ 0, %vector.main.loop.iter.check.i ]
  %const_mat = add i64 %const, 28
  %n.vec5.i = and i64 %arg.blocks.3.3.2, %const_mat
  br label %vec.epilog.vector.body.i

vec.epilog.vector.body.i:                         ; preds = %vec.epilog.vector.body.i, %vec.epilog.ph.i
  %index6.i = phi i64 [ %vec.epilog.resume.val.i, %vec.epilog.ph.i ], [ %index.next7.i, %vec.epilog.vector.body.i ]
  %4 = shl i64 %index6.i, 3
  %scevgep35 = getelementptr i8, ptr %arg.blocks.3.3.4, i64 %4
  store <4 x double> zeroinitializer, ptr %scevgep35, align 8, !noalias !271
  %5 = shl i64 %index6.i, 3
  %scevgep34 = getelementptr i8, ptr %arg.blocks.3.4.4, i64 %5
  store <4 x double> zeroinitializer, ptr %scevgep34, align 8, !noalias !271
  %index.next7.i = add nuw i64 %index6.i, 4
  %6 = icmp eq i64 %n.vec5.i, %index.next7.i
  br i1 %6, label %vec.epilog.middle.block.i, label %vec.epilog.vector.body.i, !llvm.loop !275

vec.epilog.middle.block.i:                        ; preds = %vec.epilog.vector.body.i
  %cmp.n8.i = icmp eq i64 %arg.blocks.3.3.2, %n.vec5.i
  br i1 %cmp.n8.i, label %B0.endif.endif.endif, label %B56.preheader.i

B56.preheader.i:                                  ; preds = %vec.epilog.middle.block.i, %vec.epilog.iter.check.i, %iter.check.i
  %.155178180.ph.i = phi i64 [ 0, %iter.check.i ], [ %n.vec.i, %vec.epilog.iter.check.i ], [ %n.vec5.i, %vec.epilog.middle.block.i ]
  %7 = sub nsw i64 %arg.blocks.3.3.2, %.155178180.ph.i
  %xtraiter.i = and i64 %7, 7
  %lcmp.mod.not.i = icmp eq i64 %xtraiter.i, 0
  br i1 %lcmp.mod.not.i, label %B56.prol.loopexit.i, label %B56.prol.i.preheader

B56.prol.i.preheader:                             ; preds = %B56.preheader.i
  br label %B56.prol.i

B56.prol.i:                                       ; preds = %B56.prol.i.preheader, %B56.prol.i
  %lsr.iv = phi i64 [ %xtraiter.i, %B56.prol.i.preheader ], [ %lsr.iv.next, %B56.prol.i ]
  %.155178180.prol.i = phi i64 [ %.162.prol.i, %B56.prol.i ], [ %.155178180.ph.i, %B56.prol.i.preheader ]
  %.162.prol.i = add nuw i64 %.155178180.prol.i, 1
  %8 = shl i64 %.155178180.prol.i, 3
  %scevgep33 = getelementptr i8, ptr %arg.blocks.3.3.4, i64 %8
  store double 0.000000e+00, ptr %scevgep33, align 8, !noalias !271
  %9 = shl i64 %.155178180.prol.i, 3
  %scevgep32 = getelementptr i8, ptr %arg.blocks.3.4.4, i64 %9
  store double 0.000000e+00, ptr %scevgep32, align 8, !noalias !271
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %prol.iter.cmp.not.i = icmp eq i64 %lsr.iv.next, 0
  br i1 %prol.iter.cmp.not.i, label %B56.prol.loopexit.i, label %B56.prol.i, !llvm.loop !276

B56.prol.loopexit.i:                              ; preds = %B56.prol.i, %B56.preheader.i
  %.155178180.unr.i = phi i64 [ %.155178180.ph.i, %B56.preheader.i ], [ %.162.prol.i, %B56.prol.i ]
  %10 = sub nsw i64 %.155178180.ph.i, %arg.blocks.3.3.2
  %11 = icmp ugt i64 %10, -8
  br i1 %11, label %B0.endif.endif.endif, label %B56.i.preheader

B56.i.preheader:                                  ; preds = %B56.prol.loopexit.i
  br label %B56.i

B56.i:                                            ; preds = %B56.i.preheader, %B56.i
  %.155178180.i = phi i64 [ %.162.7.i, %B56.i ], [ %.155178180.unr.i, %B56.i.preheader ]
  %sunkaddr = mul i64 %.155178180.i, 8
  %sunkaddr38 = getelementptr i8, ptr %arg.blocks.3.3.4, i64 %sunkaddr
  store double 0.000000e+00, ptr %sunkaddr38, align 8, !noalias !271
  %sunkaddr39 = mul i64 %.155178180.i, 8
  %sunkaddr40 = getelementptr i8, ptr %arg.blocks.3.4.4, i64 %sunkaddr39
  store double 0.000000e+00, ptr %sunkaddr40, align 8, !noalias !271
  %sunkaddr41 = mul i64 %.155178180.i, 8
  %sunkaddr42 = getelementptr i8, ptr %arg.blocks.3.3.4, i64 %sunkaddr41
  %sunkaddr43 = getelementptr i8, ptr %sunkaddr42, i64 8
  store double 0.000000e+00, ptr %sunkaddr43, align 8, !noalias !271
  %sunkaddr44 = mul i64 %.155178180.i, 8
  %sunkaddr45 = getelementptr i8, ptr %arg.blocks.3.4.4, i64 %sunkaddr44
  %sunkaddr46 = getelementptr i8, ptr %sunkaddr45, i64 8
  store double 0.000000e+00, ptr %sunkaddr46, align 8, !noalias !271
  %sunkaddr47 = mul i64 %.155178180.i, 8
  %sunkaddr48 = getelementptr i8, ptr %arg.blocks.3.3.4, i64 %sunkaddr47
  %sunkaddr49 = getelementptr i8, ptr %sunkaddr48, i64 16
  store double 0.000000e+00, ptr %sunkaddr49, align 8, !noalias !271
  %sunkaddr50 = mul i64 %.155178180.i, 8
  %sunkaddr51 = getelementptr i8, ptr %arg.blocks.3.4.4, i64 %sunkaddr50
  %sunkaddr52 = getelementptr i8, ptr %sunkaddr51, i64 16
  store double 0.000000e+00, ptr %sunkaddr52, align 8, !noalias !271
  %sunkaddr53 = mul i64 %.155178180.i, 8
  %sunkaddr54 = getelementptr i8, ptr %arg.blocks.3.3.4, i64 %sunkaddr53
  %sunkaddr55 = getelementptr i8, ptr %sunkaddr54, i64 24
  store double 0.000000e+00, ptr %sunkaddr55, align 8, !noalias !271
  %sunkaddr56 = mul i64 %.155178180.i, 8
  %sunkaddr57 = getelementptr i8, ptr %arg.blocks.3.4.4, i64 %sunkaddr56
  %sunkaddr58 = getelementptr i8, ptr %sunkaddr57, i64 24
  store double 0.000000e+00, ptr %sunkaddr58, align 8, !noalias !271
  %sunkaddr59 = mul i64 %.155178180.i, 8
  %sunkaddr60 = getelementptr i8, ptr %arg.blocks.3.3.4, i64 %sunkaddr59
  %sunkaddr61 = getelementptr i8, ptr %sunkaddr60, i64 32
  store double 0.000000e+00, ptr %sunkaddr61, align 8, !noalias !271
  %sunkaddr62 = mul i64 %.155178180.i, 8
  %sunkaddr63 = getelementptr i8, ptr %arg.blocks.3.4.4, i64 %sunkaddr62
  %sunkaddr64 = getelementptr i8, ptr %sunkaddr63, i64 32
  store double 0.000000e+00, ptr %sunkaddr64, align 8, !noalias !271
  %sunkaddr65 = mul i64 %.155178180.i, 8
  %sunkaddr66 = getelementptr i8, ptr %arg.blocks.3.3.4, i64 %sunkaddr65
  %sunkaddr67 = getelementptr i8, ptr %sunkaddr66, i64 40
  store double 0.000000e+00, ptr %sunkaddr67, align 8, !noalias !271
  %sunkaddr68 = mul i64 %.155178180.i, 8
  %sunkaddr69 = getelementptr i8, ptr %arg.blocks.3.4.4, i64 %sunkaddr68
  %sunkaddr70 = getelementptr i8, ptr %sunkaddr69, i64 40
  store double 0.000000e+00, ptr %sunkaddr70, align 8, !noalias !271
  %sunkaddr71 = mul i64 %.155178180.i, 8
  %sunkaddr72 = getelementptr i8, ptr %arg.blocks.3.3.4, i64 %sunkaddr71
  %sunkaddr73 = getelementptr i8, ptr %sunkaddr72, i64 48
  store double 0.000000e+00, ptr %sunkaddr73, align 8, !noalias !271
  %sunkaddr74 = mul i64 %.155178180.i, 8
  %sunkaddr75 = getelementptr i8, ptr %arg.blocks.3.4.4, i64 %sunkaddr74
  %sunkaddr76 = getelementptr i8, ptr %sunkaddr75, i64 48
  store double 0.000000e+00, ptr %sunkaddr76, align 8, !noalias !271
  %.162.7.i = add nuw nsw i64 %.155178180.i, 8
  %sunkaddr77 = mul i64 %.155178180.i, 8
  %sunkaddr78 = getelementptr i8, ptr %arg.blocks.3.3.4, i64 %sunkaddr77
  %sunkaddr79 = getelementptr i8, ptr %sunkaddr78, i64 56
  store double 0.000000e+00, ptr %sunkaddr79, align 8, !noalias !271
  %sunkaddr80 = mul i64 %.155178180.i, 8
  %sunkaddr81 = getelementptr i8, ptr %arg.blocks.3.4.4, i64 %sunkaddr80
  %sunkaddr82 = getelementptr i8, ptr %sunkaddr81, i64 56
  store double 0.000000e+00, ptr %sunkaddr82, align 8, !noalias !271
  %exitcond.not.7.i = icmp eq i64 %arg.blocks.3.3.2, %.162.7.i
  br i1 %exitcond.not.7.i, label %B0.endif.endif.endif, label %B56.i, !llvm.loop !277

B0.endif.if.if:                                   ; preds = %B0.endif
  %.332 = icmp sgt i32 %.324, 0
  %.325 = load ptr, ptr %excinfo.2, align 8
  %.333 = select i1 %.332, ptr %.325, ptr undef
  store ptr %.333, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif:                             ; preds = %B56.i, %B56.prol.loopexit.i, %vec.epilog.middle.block.i, %middle.block.i, %B0.endif.endif
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

define linkonce_odr range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels5model7contact17indentation_underB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, ptr %arg.contact.0.0, ptr readnone captures(none) %arg.contact.0.1, i64 %arg.contact.0.2, i64 %arg.contact.0.3, ptr %arg.contact.0.4, i64 %arg.contact.0.5.0, i64 %arg.contact.0.5.1, i64 %arg.contact.0.6.0, i64 %arg.contact.0.6.1, ptr %arg.contact.1.0, ptr readnone captures(none) %arg.contact.1.1, i64 %arg.contact.1.2, i64 %arg.contact.1.3, ptr captures(none) %arg.contact.1.4, i64 %arg.contact.1.5.0, i64 %arg.contact.1.6.0, ptr %arg.contact.2.0, ptr readnone captures(none) %arg.contact.2.1, i64 %arg.contact.2.2, i64 %arg.contact.2.3, ptr captures(none) %arg.contact.2.4, i64 %arg.contact.2.5.0, i64 %arg.contact.2.6.0, double %arg.load, double %arg.guess) local_unnamed_addr {
B0:
  %.172.i2 = alloca [2 x double], align 8
  %excinfo.2.i3 = alloca ptr, align 8
  %.172.i = alloca [2 x double], align 8
  %excinfo.2.i = alloca ptr, align 8
  %.121 = alloca [2 x double], align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  call void @llvm.lifetime.start.p0(ptr nonnull %.172.i2)
  call void @llvm.lifetime.start.p0(ptr nonnull %excinfo.2.i3)
  tail call void @NRT_incref(ptr %arg.contact.0.0), !noalias !278
  tail call void @NRT_incref(ptr %arg.contact.2.0), !noalias !278
  %.80.i = load double, ptr %arg.contact.1.4, align 8, !noalias !278
  %.12.i.i = fcmp ogt double %arg.guess, %.80.i
  %.13.i.i = select i1 %.12.i.i, double %arg.guess, double %.80.i
  store double %.13.i.i, ptr %arg.contact.1.4, align 8, !noalias !278
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.172.i2, i8 0, i64 16, i1 false), !noalias !278
  %.182.i = call i32 @_ZN18elastomer_friction7kernels5model7contact15overlap_of_rowsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE(ptr nonnull %.172.i2, ptr nonnull %excinfo.2.i3, ptr %arg.contact.0.0, ptr readnone %arg.contact.0.1, i64 %arg.contact.0.2, i64 %arg.contact.0.3, ptr readonly %arg.contact.0.4, i64 %arg.contact.0.5.0, i64 %arg.contact.0.5.1, i64 %arg.contact.0.6.0, i64 %arg.contact.0.6.1, double %arg.guess, ptr %arg.contact.2.0, ptr readnone %arg.contact.2.1, i64 %arg.contact.2.2, i64 %arg.contact.2.3, ptr %arg.contact.2.4, i64 %arg.contact.2.5.0, i64 %arg.contact.2.6.0), !noalias !278
  switch i32 %.182.i, label %_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd.exit [
    i32 -2, label %B22.endif.peel
    i32 0, label %B22.endif.peel
  ], !prof !1

_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd.exit: ; preds = %B0
  call void @llvm.lifetime.end.p0(ptr nonnull %.172.i2)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.2.i3)
  br label %B22.if.if

B22.endif.peel:                                   ; preds = %B0, %B0
  %.fca.1.gep.i = getelementptr inbounds nuw i8, ptr %.172.i2, i64 8
  %.192.fca.1.load.i = load double, ptr %.fca.1.gep.i, align 8, !noalias !278
  %.192.fca.0.load.i = load double, ptr %.172.i2, align 8, !noalias !278
  tail call void @NRT_decref(ptr %arg.contact.0.0), !noalias !278
  tail call void @NRT_decref(ptr %arg.contact.2.0), !noalias !278
  call void @llvm.lifetime.end.p0(ptr nonnull %.172.i2)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.2.i3)
  %.111.peel = fcmp oeq double %.192.fca.1.load.i, 0.000000e+00
  br i1 %.111.peel, label %B86.peel, label %B228.endif.peel

B228.endif.peel:                                  ; preds = %B22.endif.peel
  %.218.i = fsub double %.192.fca.0.load.i, %arg.load
  %.246.peel = fdiv double %.218.i, %.192.fca.1.load.i
  %.252.peel = fsub double %arg.guess, %.246.peel
  br label %B288.peel

B86.peel:                                         ; preds = %B22.endif.peel
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.121, i8 0, i64 16, i1 false)
  %.133.peel = call i32 @_ZN18elastomer_friction7kernels5model7contact22_lowest_of_spring_rowsB3v53B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29d(ptr nonnull %.121, ptr nonnull %excinfo.2, ptr %arg.contact.0.0, ptr %arg.contact.0.1, i64 %arg.contact.0.2, i64 %arg.contact.0.3, ptr %arg.contact.0.4, i64 %arg.contact.0.5.0, i64 %arg.contact.0.5.1, i64 %arg.contact.0.6.0, i64 %arg.contact.0.6.1, ptr %arg.contact.1.0, ptr %arg.contact.1.1, i64 %arg.contact.1.2, i64 %arg.contact.1.3, ptr nonnull %arg.contact.1.4, i64 %arg.contact.1.5.0, i64 %arg.contact.1.6.0, ptr %arg.contact.2.0, ptr %arg.contact.2.1, i64 %arg.contact.2.2, i64 %arg.contact.2.3, ptr %arg.contact.2.4, i64 %arg.contact.2.5.0, i64 %arg.contact.2.6.0, double %arg.load)
  %cond = icmp eq i32 %.133.peel, 0
  br i1 %cond, label %B86.endif.peel, label %B86.if, !prof !0

B86.endif.peel:                                   ; preds = %B86.peel
  %sunkaddr = getelementptr inbounds i8, ptr %.121, i64 8
  %.143.fca.1.load.peel = load double, ptr %sunkaddr, align 8
  %.167.peel = fcmp ule double %.143.fca.1.load.peel, %arg.guess
  br i1 %.167.peel, label %B140, label %B288.peel

B288.peel:                                        ; preds = %B86.endif.peel, %B228.endif.peel
  %new.2.1.peel = phi double [ %.252.peel, %B228.endif.peel ], [ %.143.fca.1.load.peel, %B86.endif.peel ]
  br label %B22.outer

B22.outer:                                        ; preds = %B86.endif, %B288.peel
  %.57.sroa.6.0.ph = phi double [ %.192.fca.1.load.i10, %B86.endif ], [ %.192.fca.1.load.i, %B288.peel ]
  %d.2.0.ph = phi double [ %.143.fca.1.load, %B86.endif ], [ %new.2.1.peel, %B288.peel ]
  %fallen.2.0.ph = phi i1 [ true, %B86.endif ], [ %.111.peel, %B288.peel ]
  %passes.2.0.ph = phi i64 [ %0, %B86.endif ], [ 1, %B288.peel ]
  br label %B22

B22:                                              ; preds = %B256, %B22.outer
  %.57.sroa.6.0 = phi double [ %.192.fca.1.load.i10, %B256 ], [ %.57.sroa.6.0.ph, %B22.outer ]
  %d.2.0 = phi double [ %.252, %B256 ], [ %d.2.0.ph, %B22.outer ]
  %passes.2.0 = phi i64 [ %.104, %B256 ], [ %passes.2.0.ph, %B22.outer ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.172.i2)
  call void @llvm.lifetime.start.p0(ptr nonnull %excinfo.2.i3)
  tail call void @NRT_incref(ptr %arg.contact.0.0), !noalias !282
  tail call void @NRT_incref(ptr %arg.contact.2.0), !noalias !282
  %.80.i4 = load double, ptr %arg.contact.1.4, align 8, !noalias !282
  %.12.i.i5 = fcmp ogt double %d.2.0, %.80.i4
  %.13.i.i6 = select i1 %.12.i.i5, double %d.2.0, double %.80.i4
  store double %.13.i.i6, ptr %arg.contact.1.4, align 8, !noalias !282
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.172.i2, i8 0, i64 16, i1 false), !noalias !282
  %.182.i7 = call i32 @_ZN18elastomer_friction7kernels5model7contact15overlap_of_rowsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE(ptr nonnull %.172.i2, ptr nonnull %excinfo.2.i3, ptr %arg.contact.0.0, ptr readnone %arg.contact.0.1, i64 %arg.contact.0.2, i64 %arg.contact.0.3, ptr readonly %arg.contact.0.4, i64 %arg.contact.0.5.0, i64 %arg.contact.0.5.1, i64 %arg.contact.0.6.0, i64 %arg.contact.0.6.1, double %d.2.0, ptr %arg.contact.2.0, ptr readnone %arg.contact.2.1, i64 %arg.contact.2.2, i64 %arg.contact.2.3, ptr %arg.contact.2.4, i64 %arg.contact.2.5.0, i64 %arg.contact.2.6.0), !noalias !282
  switch i32 %.182.i7, label %_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd.exit17 [
    i32 -2, label %B22.endif
    i32 0, label %B22.endif
  ], !prof !1

_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd.exit17: ; preds = %B22
  call void @llvm.lifetime.end.p0(ptr nonnull %.172.i2)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.2.i3)
  br label %B22.if.if

B86:                                              ; preds = %B22.endif
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.121, i8 0, i64 16, i1 false)
  %.133 = call i32 @_ZN18elastomer_friction7kernels5model7contact22_lowest_of_spring_rowsB3v53B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29d(ptr nonnull %.121, ptr nonnull %excinfo.2, ptr %arg.contact.0.0, ptr %arg.contact.0.1, i64 %arg.contact.0.2, i64 %arg.contact.0.3, ptr %arg.contact.0.4, i64 %arg.contact.0.5.0, i64 %arg.contact.0.5.1, i64 %arg.contact.0.6.0, i64 %arg.contact.0.6.1, ptr %arg.contact.1.0, ptr %arg.contact.1.1, i64 %arg.contact.1.2, i64 %arg.contact.1.3, ptr nonnull %arg.contact.1.4, i64 %arg.contact.1.5.0, i64 %arg.contact.1.6.0, ptr %arg.contact.2.0, ptr %arg.contact.2.1, i64 %arg.contact.2.2, i64 %arg.contact.2.3, ptr %arg.contact.2.4, i64 %arg.contact.2.5.0, i64 %arg.contact.2.6.0, double %arg.load)
  %cond1 = icmp eq i32 %.133, 0
  %0 = add i64 %passes.2.0, 1
  br i1 %cond1, label %B86.endif, label %B86.if, !prof !0

B140.loopexit:                                    ; preds = %B86.endif
  %1 = add i64 %passes.2.0, 1
  br label %B140

B140:                                             ; preds = %B140.loopexit, %B86.endif.peel
  %.104.lcssa130 = phi i64 [ 1, %B86.endif.peel ], [ %1, %B140.loopexit ]
  %d.2.0.lcssa128 = phi double [ %arg.guess, %B86.endif.peel ], [ %d.2.0, %B140.loopexit ]
  %.143.fca.0.load.lcssa = load double, ptr %.121, align 8
  %.179 = fcmp ugt double %d.2.0.lcssa128, %.143.fca.0.load.lcssa
  br i1 %.179, label %B216, label %for.cond.preheader

for.cond.preheader:                               ; preds = %B140
  %.193 = tail call double @numba_nextafter(double %.143.fca.0.load.lcssa, double 0x7FF0000000000000)
  br label %B216

common.ret:                                       ; preds = %B86.if, %B22.if.if, %B280, %B216
  %common.ret.op = phi i32 [ 0, %B216 ], [ 0, %B280 ], [ %.69.lcssa, %B22.if.if ], [ 1, %B86.if ]
  ret i32 %common.ret.op

B216:                                             ; preds = %for.cond.preheader, %B140
  %"$phi216.0.2.0" = phi double [ %d.2.0.lcssa128, %B140 ], [ %.193, %for.cond.preheader ]
  store double %"$phi216.0.2.0", ptr %retptr, align 8
  %retptr.repack111 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store i64 %.104.lcssa130, ptr %retptr.repack111, align 8
  br label %common.ret

B256:                                             ; preds = %B22.endif
  %.218.i12 = fsub double %.192.fca.0.load.i11, %arg.load
  %.246 = fdiv double %.218.i12, %.192.fca.1.load.i10
  %.252 = fsub double %d.2.0, %.246
  %.268 = fcmp une double %.192.fca.1.load.i10, %.57.sroa.6.0
  %.282 = fcmp olt double %.252, %d.2.0
  %or.cond108 = select i1 %.268, i1 %.282, i1 false
  %.104 = add i64 %passes.2.0, 1
  br i1 %or.cond108, label %B22, label %B280, !llvm.loop !286

B280:                                             ; preds = %B256
  store double %.252, ptr %retptr, align 8
  %retptr.repack109 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store i64 %.104, ptr %retptr.repack109, align 8
  br label %common.ret

B22.endif:                                        ; preds = %B22, %B22
  %sunkaddr57 = getelementptr inbounds i8, ptr %.172.i2, i64 8
  %.192.fca.1.load.i10 = load double, ptr %sunkaddr57, align 8, !noalias !282
  %.192.fca.0.load.i11 = load double, ptr %.172.i2, align 8, !noalias !282
  tail call void @NRT_decref(ptr %arg.contact.0.0), !noalias !282
  tail call void @NRT_decref(ptr %arg.contact.2.0), !noalias !282
  call void @llvm.lifetime.end.p0(ptr nonnull %.172.i2)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.2.i3)
  %.111 = fcmp oeq double %.192.fca.1.load.i10, 0.000000e+00
  br i1 %.111, label %B86, label %B256

B22.if.if:                                        ; preds = %_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd.exit17, %_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd.exit
  %.69.lcssa = phi i32 [ %.182.i, %_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd.exit ], [ %.182.i7, %_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd.exit17 ]
  store ptr null, ptr %excinfo, align 8
  br label %common.ret

B86.if:                                           ; preds = %B86, %B86.peel
  %.134 = load ptr, ptr %excinfo.2, align 8
  store ptr %.134, ptr %excinfo, align 8
  br label %common.ret

B86.endif:                                        ; preds = %B86
  %sunkaddr58 = getelementptr inbounds i8, ptr %.121, i64 8
  %.143.fca.1.load = load double, ptr %sunkaddr58, align 8
  %.167 = fcmp ule double %.143.fca.1.load, %d.2.0
  %or.cond.not = select i1 %fallen.2.0.ph, i1 true, i1 %.167
  br i1 %or.cond.not, label %B140.loopexit, label %B22.outer, !llvm.loop !286
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define linkonce_odr noundef i32 @_ZN18elastomer_friction7kernels5model7contact15overlap_of_rowsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.c.0, ptr readnone captures(none) %arg.c.1, i64 %arg.c.2, i64 %arg.c.3, ptr readonly captures(none) %arg.c.4, i64 %arg.c.5.0, i64 %arg.c.5.1, i64 %arg.c.6.0, i64 %arg.c.6.1, double %arg.d, ptr readnone captures(none) %arg.sums.0, ptr readnone captures(none) %arg.sums.1, i64 %arg.sums.2, i64 %arg.sums.3, ptr captures(none) %arg.sums.4, i64 %arg.sums.5.0, i64 %arg.sums.6.0) local_unnamed_addr #9 {
B0.endif:
  %const = bitcast i64 9223372036854775776 to i64
  %.80 = icmp sgt i64 %arg.sums.2, 0
  br i1 %.80, label %B50.preheader, label %B268.else.if

B50.preheader:                                    ; preds = %B0.endif
  %0 = shl i64 %arg.sums.2, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %arg.sums.4, i8 0, i64 %0, i1 false)
  %.295397.not = icmp slt i64 %arg.c.5.0, 1
  br i1 %.295397.not, label %B268.else.if, label %B118.endif.us.preheader

B118.endif.us.preheader:                          ; preds = %B50.preheader
  %scevgep = getelementptr i8, ptr %arg.sums.4, i64 %0
  %1 = add nuw i64 %arg.c.5.0, 2305843009213693951
  %2 = mul i64 %arg.c.5.1, %1
  %3 = add i64 %arg.sums.2, %2
  %4 = shl i64 %3, 3
  %scevgep4 = getelementptr i8, ptr %arg.c.4, i64 %4
  %min.iters.check = icmp samesign ult i64 %arg.sums.2, 8
  %bound0 = icmp ult ptr %arg.sums.4, %scevgep4
  %bound1 = icmp ult ptr %arg.c.4, %scevgep
  %found.conflict = and i1 %bound0, %bound1
  %.mask = and i64 %arg.c.5.1, 1152921504606846976
  %stride.check = icmp ne i64 %.mask, 0
  %5 = or i1 %stride.check, %found.conflict
  %n.vec = and i64 %arg.sums.2, %const
  %broadcast.splatinsert = insertelement <8 x double> poison, double %arg.d, i64 0
  %broadcast.splat = shufflevector <8 x double> %broadcast.splatinsert, <8 x double> poison, <8 x i32> zeroinitializer
  %const_mat = add i64 %const, 24
  %n.vec19 = and i64 %arg.sums.2, %const_mat
  %xtraiter = and i64 %arg.sums.2, 7
  %brmerge = select i1 %min.iters.check, i1 true, i1 %5
  %scevgep54 = getelementptr i8, ptr %arg.c.4, i64 192
  %6 = shl i64 %arg.c.5.1, 3
  br label %iter.check

B332:                                             ; preds = %B332.preheader, %B332
  %.804411413 = phi i64 [ %.811, %B332 ], [ %.804411413.ph, %B332.preheader ]
  %.811 = add nuw nsw i64 %.804411413, 1
  %7 = shl i64 %.804411413, 3
  %scevgep48 = getelementptr i8, ptr %arg.sums.4, i64 %7
  %.865 = load double, ptr %scevgep48, align 8
  %8 = shl i64 %.804411413, 3
  %scevgep47 = getelementptr i8, ptr %invariant.gep, i64 %8
  %.897 = load double, ptr %scevgep47, align 8
  %.898 = fadd double %.865, %.897
  store double %.898, ptr %scevgep48, align 8
  %exitcond422.not = icmp eq i64 %half.2.0, %.811
  br i1 %exitcond422.not, label %B386.endif, label %B332, !llvm.loop !288

B408:                                             ; preds = %B386.endif, %B268.else.if
  %.1015 = load double, ptr %arg.sums.4, align 8
  store double %.1015, ptr %retptr, align 8
  %retptr.repack371 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store double %touching.3.0.lcssa, ptr %retptr.repack371, align 8
  ret i32 0

iter.check:                                       ; preds = %B160.B116.loopexit_crit_edge.us, %B118.endif.us.preheader
  %lsr.iv61 = phi ptr [ %scevgep62, %B160.B116.loopexit_crit_edge.us ], [ %arg.c.4, %B118.endif.us.preheader ]
  %lsr.iv = phi ptr [ %scevgep55, %B160.B116.loopexit_crit_edge.us ], [ %scevgep54, %B118.endif.us.preheader ]
  %touching.3.0400.us = phi i64 [ %.635.us.lcssa, %B160.B116.loopexit_crit_edge.us ], [ 0, %B118.endif.us.preheader ]
  %.301392398.us = phi i64 [ %.308.us, %B160.B116.loopexit_crit_edge.us ], [ 0, %B118.endif.us.preheader ]
  br i1 %brmerge, label %B162.us.preheader, label %vector.main.loop.iter.check

vector.main.loop.iter.check:                      ; preds = %iter.check
  %9 = icmp ult i64 %arg.sums.2, 32
  br i1 %9, label %vec.epilog.ph, label %vector.ph

vector.ph:                                        ; preds = %vector.main.loop.iter.check
  %10 = insertelement <8 x i64> <i64 poison, i64 0, i64 0, i64 0, i64 0, i64 0, i64 0, i64 0>, i64 %touching.3.0400.us, i64 0
  br label %vector.body

vector.body:                                      ; preds = %vector.body, %vector.ph
  %index = phi i64 [ 0, %vector.ph ], [ %index.next, %vector.body ]
  %vec.phi = phi <8 x i64> [ %10, %vector.ph ], [ %32, %vector.body ]
  %vec.phi6 = phi <8 x i64> [ zeroinitializer, %vector.ph ], [ %33, %vector.body ]
  %vec.phi7 = phi <8 x i64> [ zeroinitializer, %vector.ph ], [ %34, %vector.body ]
  %vec.phi8 = phi <8 x i64> [ zeroinitializer, %vector.ph ], [ %35, %vector.body ]
  %11 = shl i64 %index, 3
  %scevgep56 = getelementptr i8, ptr %lsr.iv, i64 %11
  %scevgep57 = getelementptr i8, ptr %scevgep56, i64 -192
  %scevgep59 = getelementptr i8, ptr %scevgep56, i64 -128
  %scevgep58 = getelementptr i8, ptr %scevgep56, i64 -64
  %wide.load = load <8 x double>, ptr %scevgep57, align 8, !alias.scope !289
  %wide.load9 = load <8 x double>, ptr %scevgep59, align 8, !alias.scope !289
  %wide.load10 = load <8 x double>, ptr %scevgep58, align 8, !alias.scope !289
  %wide.load11 = load <8 x double>, ptr %scevgep56, align 8, !alias.scope !289
  %12 = fsub <8 x double> %broadcast.splat, %wide.load
  %13 = fsub <8 x double> %broadcast.splat, %wide.load9
  %14 = fsub <8 x double> %broadcast.splat, %wide.load10
  %15 = fsub <8 x double> %broadcast.splat, %wide.load11
  %sunkaddr117 = mul i64 %index, 8
  %sunkaddr118 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr117
  %sunkaddr119 = getelementptr i8, ptr %sunkaddr118, i64 192
  %sunkaddr = mul i64 %index, 8
  %sunkaddr110 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr
  %wide.load12 = load <8 x double>, ptr %sunkaddr110, align 8, !alias.scope !292, !noalias !289
  %sunkaddr111 = mul i64 %index, 8
  %sunkaddr112 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr111
  %sunkaddr113 = getelementptr i8, ptr %sunkaddr112, i64 64
  %wide.load13 = load <8 x double>, ptr %sunkaddr113, align 8, !alias.scope !292, !noalias !289
  %sunkaddr114 = mul i64 %index, 8
  %sunkaddr115 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr114
  %sunkaddr116 = getelementptr i8, ptr %sunkaddr115, i64 128
  %wide.load14 = load <8 x double>, ptr %sunkaddr116, align 8, !alias.scope !292, !noalias !289
  %wide.load15 = load <8 x double>, ptr %sunkaddr119, align 8, !alias.scope !292, !noalias !289
  %16 = fcmp ogt <8 x double> %12, zeroinitializer
  %17 = fcmp ogt <8 x double> %13, zeroinitializer
  %18 = fcmp ogt <8 x double> %14, zeroinitializer
  %19 = fcmp ogt <8 x double> %15, zeroinitializer
  %20 = select <8 x i1> %16, <8 x double> %12, <8 x double> zeroinitializer
  %21 = select <8 x i1> %17, <8 x double> %13, <8 x double> zeroinitializer
  %22 = select <8 x i1> %18, <8 x double> %14, <8 x double> zeroinitializer
  %23 = select <8 x i1> %19, <8 x double> %15, <8 x double> zeroinitializer
  %24 = fadd <8 x double> %20, %wide.load12
  %25 = fadd <8 x double> %21, %wide.load13
  %26 = fadd <8 x double> %22, %wide.load14
  %27 = fadd <8 x double> %23, %wide.load15
  %28 = zext <8 x i1> %16 to <8 x i64>
  %29 = zext <8 x i1> %17 to <8 x i64>
  %30 = zext <8 x i1> %18 to <8 x i64>
  %31 = zext <8 x i1> %19 to <8 x i64>
  store <8 x double> %24, ptr %sunkaddr110, align 8, !alias.scope !292, !noalias !289
  store <8 x double> %25, ptr %sunkaddr113, align 8, !alias.scope !292, !noalias !289
  store <8 x double> %26, ptr %sunkaddr116, align 8, !alias.scope !292, !noalias !289
  store <8 x double> %27, ptr %sunkaddr119, align 8, !alias.scope !292, !noalias !289
  %32 = add <8 x i64> %vec.phi, %28
  %33 = add <8 x i64> %vec.phi6, %29
  %34 = add <8 x i64> %vec.phi7, %30
  %35 = add <8 x i64> %vec.phi8, %31
  %index.next = add nuw nsw i64 %index, 32
  %36 = icmp eq i64 %n.vec, %index.next
  br i1 %36, label %middle.block, label %vector.body, !llvm.loop !294

middle.block:                                     ; preds = %vector.body
  %37 = icmp eq i64 %arg.sums.2, %n.vec
  %bin.rdx = add <8 x i64> %33, %32
  %bin.rdx16 = add <8 x i64> %bin.rdx, %34
  %bin.rdx17 = add <8 x i64> %bin.rdx16, %35
  %rdx.shuf = shufflevector <8 x i64> %bin.rdx17, <8 x i64> poison, <8 x i32> <i32 4, i32 5, i32 6, i32 7, i32 poison, i32 poison, i32 poison, i32 poison>
  %bin.rdx99 = add <8 x i64> %bin.rdx17, %rdx.shuf
  %rdx.shuf100 = shufflevector <8 x i64> %bin.rdx99, <8 x i64> poison, <8 x i32> <i32 2, i32 3, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison>
  %bin.rdx101 = add <8 x i64> %bin.rdx99, %rdx.shuf100
  %rdx.shuf102 = shufflevector <8 x i64> %bin.rdx101, <8 x i64> poison, <8 x i32> <i32 1, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison>
  %bin.rdx103 = add <8 x i64> %bin.rdx101, %rdx.shuf102
  %38 = extractelement <8 x i64> %bin.rdx103, i32 0
  br i1 %37, label %B160.B116.loopexit_crit_edge.us, label %vec.epilog.iter.check

vec.epilog.iter.check:                            ; preds = %middle.block
  %39 = and i64 %arg.sums.2, 24
  %40 = icmp eq i64 %39, 0
  br i1 %40, label %B162.us.preheader, label %vec.epilog.ph, !prof !295

vec.epilog.ph:                                    ; preds = %vec.epilog.iter.check, %vector.main.loop.iter.check
  %vec.epilog.resume.val = phi i64 [ %n.vec, %vec.epilog.iter.check ], [ 0, %vector.main.loop.iter.check ]
  %bc.merge.rdx = phi i64 [ %38, %vec.epilog.iter.check ], [ %touching.3.0400.us, %vector.main.loop.iter.check ]
  %41 = insertelement <8 x i64> <i64 poison, i64 0, i64 0, i64 0, i64 0, i64 0, i64 0, i64 0>, i64 %bc.merge.rdx, i64 0
  br label %vec.epilog.vector.body

vec.epilog.vector.body:                           ; preds = %vec.epilog.vector.body, %vec.epilog.ph
  %index22 = phi i64 [ %vec.epilog.resume.val, %vec.epilog.ph ], [ %index.next26, %vec.epilog.vector.body ]
  %vec.phi23 = phi <8 x i64> [ %41, %vec.epilog.ph ], [ %49, %vec.epilog.vector.body ]
  %42 = shl i64 %index22, 3
  %scevgep63 = getelementptr i8, ptr %lsr.iv61, i64 %42
  %wide.load24 = load <8 x double>, ptr %scevgep63, align 8, !alias.scope !289
  %43 = fsub <8 x double> %broadcast.splat, %wide.load24
  %44 = shl i64 %index22, 3
  %scevgep60 = getelementptr i8, ptr %arg.sums.4, i64 %44
  %wide.load25 = load <8 x double>, ptr %scevgep60, align 8, !alias.scope !292, !noalias !289
  %45 = fcmp ogt <8 x double> %43, zeroinitializer
  %46 = select <8 x i1> %45, <8 x double> %43, <8 x double> zeroinitializer
  %47 = fadd <8 x double> %wide.load25, %46
  %48 = zext <8 x i1> %45 to <8 x i64>
  store <8 x double> %47, ptr %scevgep60, align 8, !alias.scope !292, !noalias !289
  %49 = add <8 x i64> %vec.phi23, %48
  %index.next26 = add nuw i64 %index22, 8
  %50 = icmp eq i64 %n.vec19, %index.next26
  br i1 %50, label %vec.epilog.middle.block, label %vec.epilog.vector.body, !llvm.loop !296

vec.epilog.middle.block:                          ; preds = %vec.epilog.vector.body
  %51 = icmp eq i64 %arg.sums.2, %n.vec19
  %rdx.shuf104 = shufflevector <8 x i64> %49, <8 x i64> poison, <8 x i32> <i32 4, i32 5, i32 6, i32 7, i32 poison, i32 poison, i32 poison, i32 poison>
  %bin.rdx105 = add <8 x i64> %49, %rdx.shuf104
  %rdx.shuf106 = shufflevector <8 x i64> %bin.rdx105, <8 x i64> poison, <8 x i32> <i32 2, i32 3, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison>
  %bin.rdx107 = add <8 x i64> %bin.rdx105, %rdx.shuf106
  %rdx.shuf108 = shufflevector <8 x i64> %bin.rdx107, <8 x i64> poison, <8 x i32> <i32 1, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison>
  %bin.rdx109 = add <8 x i64> %bin.rdx107, %rdx.shuf108
  %52 = extractelement <8 x i64> %bin.rdx109, i32 0
  br i1 %51, label %B160.B116.loopexit_crit_edge.us, label %B162.us.preheader

B162.us.preheader:                                ; preds = %vec.epilog.middle.block, %vec.epilog.iter.check, %iter.check
  %touching.2.1387.us.ph = phi i64 [ %touching.3.0400.us, %iter.check ], [ %52, %vec.epilog.middle.block ], [ %38, %vec.epilog.iter.check ]
  %.434383385.us.ph = phi i64 [ 0, %iter.check ], [ %n.vec19, %vec.epilog.middle.block ], [ %n.vec, %vec.epilog.iter.check ]
  %53 = icmp eq i64 %xtraiter, 0
  br i1 %53, label %B162.us.prol.loopexit, label %B162.us.prol.preheader

B162.us.prol.preheader:                           ; preds = %B162.us.preheader
  br label %B162.us.prol

B162.us.prol:                                     ; preds = %B162.us.prol.preheader, %B162.us.prol
  %lsr.iv66 = phi i64 [ %xtraiter, %B162.us.prol.preheader ], [ %lsr.iv.next, %B162.us.prol ]
  %touching.2.1387.us.prol = phi i64 [ %.635.us.prol, %B162.us.prol ], [ %touching.2.1387.us.ph, %B162.us.prol.preheader ]
  %.434383385.us.prol = phi i64 [ %.441.us.prol, %B162.us.prol ], [ %.434383385.us.ph, %B162.us.prol.preheader ]
  %.441.us.prol = add nuw nsw i64 %.434383385.us.prol, 1
  %54 = shl i64 %.434383385.us.prol, 3
  %scevgep65 = getelementptr i8, ptr %lsr.iv61, i64 %54
  %.516.us.prol = load double, ptr %scevgep65, align 8
  %.518.us.prol = fsub double %arg.d, %.516.us.prol
  %55 = shl i64 %.434383385.us.prol, 3
  %scevgep64 = getelementptr i8, ptr %arg.sums.4, i64 %55
  %.551.us.prol = load double, ptr %scevgep64, align 8
  %.553.us.prol = fcmp ogt double %.518.us.prol, 0.000000e+00
  %storemerge374.us.v.prol = select i1 %.553.us.prol, double %.518.us.prol, double 0.000000e+00
  %storemerge374.us.prol = fadd double %.551.us.prol, %storemerge374.us.v.prol
  %"$phi258.3.2.2.us.prol" = zext i1 %.553.us.prol to i64
  store double %storemerge374.us.prol, ptr %scevgep64, align 8
  %.635.us.prol = add nsw i64 %touching.2.1387.us.prol, %"$phi258.3.2.2.us.prol"
  %lsr.iv.next = add nsw i64 %lsr.iv66, -1
  %prol.iter.cmp.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %prol.iter.cmp.not, label %B162.us.prol.loopexit, label %B162.us.prol, !llvm.loop !297

B162.us.prol.loopexit:                            ; preds = %B162.us.prol, %B162.us.preheader
  %.635.us.lcssa69.unr = phi i64 [ poison, %B162.us.preheader ], [ %.635.us.prol, %B162.us.prol ]
  %touching.2.1387.us.unr = phi i64 [ %touching.2.1387.us.ph, %B162.us.preheader ], [ %.635.us.prol, %B162.us.prol ]
  %.434383385.us.unr = phi i64 [ %.434383385.us.ph, %B162.us.preheader ], [ %.441.us.prol, %B162.us.prol ]
  %56 = sub nsw i64 %.434383385.us.ph, %arg.sums.2
  %57 = icmp ugt i64 %56, -8
  br i1 %57, label %B160.B116.loopexit_crit_edge.us, label %B162.us.preheader34

B162.us.preheader34:                              ; preds = %B162.us.prol.loopexit
  br label %B162.us

B162.us:                                          ; preds = %B162.us.preheader34, %B162.us
  %touching.2.1387.us = phi i64 [ %.635.us.7, %B162.us ], [ %touching.2.1387.us.unr, %B162.us.preheader34 ]
  %.434383385.us = phi i64 [ %.441.us.7, %B162.us ], [ %.434383385.us.unr, %B162.us.preheader34 ]
  %58 = shl i64 %.434383385.us, 3
  %scevgep85 = getelementptr i8, ptr %lsr.iv61, i64 %58
  %.516.us = load double, ptr %scevgep85, align 8
  %.518.us = fsub double %arg.d, %.516.us
  %sunkaddr120 = mul i64 %.434383385.us, 8
  %sunkaddr121 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr120
  %.551.us = load double, ptr %sunkaddr121, align 8
  %.553.us = fcmp ogt double %.518.us, 0.000000e+00
  %storemerge374.us.v = select i1 %.553.us, double %.518.us, double 0.000000e+00
  %storemerge374.us = fadd double %.551.us, %storemerge374.us.v
  %"$phi258.3.2.2.us" = zext i1 %.553.us to i64
  store double %storemerge374.us, ptr %sunkaddr121, align 8
  %.635.us = add nsw i64 %touching.2.1387.us, %"$phi258.3.2.2.us"
  %59 = shl i64 %.434383385.us, 3
  %scevgep88 = getelementptr i8, ptr %lsr.iv61, i64 %59
  %scevgep89 = getelementptr i8, ptr %scevgep88, i64 8
  %.516.us.1 = load double, ptr %scevgep89, align 8
  %.518.us.1 = fsub double %arg.d, %.516.us.1
  %sunkaddr122 = mul i64 %.434383385.us, 8
  %sunkaddr123 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr122
  %sunkaddr124 = getelementptr i8, ptr %sunkaddr123, i64 8
  %.551.us.1 = load double, ptr %sunkaddr124, align 8
  %.553.us.1 = fcmp ogt double %.518.us.1, 0.000000e+00
  %storemerge374.us.v.1 = select i1 %.553.us.1, double %.518.us.1, double 0.000000e+00
  %storemerge374.us.1 = fadd double %.551.us.1, %storemerge374.us.v.1
  %"$phi258.3.2.2.us.1" = zext i1 %.553.us.1 to i64
  store double %storemerge374.us.1, ptr %sunkaddr124, align 8
  %.635.us.1 = add nsw i64 %.635.us, %"$phi258.3.2.2.us.1"
  %60 = shl i64 %.434383385.us, 3
  %scevgep90 = getelementptr i8, ptr %lsr.iv61, i64 %60
  %scevgep91 = getelementptr i8, ptr %scevgep90, i64 16
  %.516.us.2 = load double, ptr %scevgep91, align 8
  %.518.us.2 = fsub double %arg.d, %.516.us.2
  %sunkaddr125 = mul i64 %.434383385.us, 8
  %sunkaddr126 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr125
  %sunkaddr127 = getelementptr i8, ptr %sunkaddr126, i64 16
  %.551.us.2 = load double, ptr %sunkaddr127, align 8
  %.553.us.2 = fcmp ogt double %.518.us.2, 0.000000e+00
  %storemerge374.us.v.2 = select i1 %.553.us.2, double %.518.us.2, double 0.000000e+00
  %storemerge374.us.2 = fadd double %.551.us.2, %storemerge374.us.v.2
  %"$phi258.3.2.2.us.2" = zext i1 %.553.us.2 to i64
  store double %storemerge374.us.2, ptr %sunkaddr127, align 8
  %.635.us.2 = add nsw i64 %.635.us.1, %"$phi258.3.2.2.us.2"
  %61 = shl i64 %.434383385.us, 3
  %scevgep92 = getelementptr i8, ptr %lsr.iv61, i64 %61
  %scevgep93 = getelementptr i8, ptr %scevgep92, i64 24
  %.516.us.3 = load double, ptr %scevgep93, align 8
  %.518.us.3 = fsub double %arg.d, %.516.us.3
  %sunkaddr128 = mul i64 %.434383385.us, 8
  %sunkaddr129 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr128
  %sunkaddr130 = getelementptr i8, ptr %sunkaddr129, i64 24
  %.551.us.3 = load double, ptr %sunkaddr130, align 8
  %.553.us.3 = fcmp ogt double %.518.us.3, 0.000000e+00
  %storemerge374.us.v.3 = select i1 %.553.us.3, double %.518.us.3, double 0.000000e+00
  %storemerge374.us.3 = fadd double %.551.us.3, %storemerge374.us.v.3
  %"$phi258.3.2.2.us.3" = zext i1 %.553.us.3 to i64
  store double %storemerge374.us.3, ptr %sunkaddr130, align 8
  %.635.us.3 = add nsw i64 %.635.us.2, %"$phi258.3.2.2.us.3"
  %62 = shl i64 %.434383385.us, 3
  %scevgep83 = getelementptr i8, ptr %lsr.iv61, i64 %62
  %scevgep84 = getelementptr i8, ptr %scevgep83, i64 32
  %.516.us.4 = load double, ptr %scevgep84, align 8
  %.518.us.4 = fsub double %arg.d, %.516.us.4
  %sunkaddr131 = mul i64 %.434383385.us, 8
  %sunkaddr132 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr131
  %sunkaddr133 = getelementptr i8, ptr %sunkaddr132, i64 32
  %.551.us.4 = load double, ptr %sunkaddr133, align 8
  %.553.us.4 = fcmp ogt double %.518.us.4, 0.000000e+00
  %storemerge374.us.v.4 = select i1 %.553.us.4, double %.518.us.4, double 0.000000e+00
  %storemerge374.us.4 = fadd double %.551.us.4, %storemerge374.us.v.4
  %"$phi258.3.2.2.us.4" = zext i1 %.553.us.4 to i64
  store double %storemerge374.us.4, ptr %sunkaddr133, align 8
  %.635.us.4 = add nsw i64 %.635.us.3, %"$phi258.3.2.2.us.4"
  %63 = shl i64 %.434383385.us, 3
  %scevgep96 = getelementptr i8, ptr %lsr.iv61, i64 %63
  %scevgep97 = getelementptr i8, ptr %scevgep96, i64 40
  %.516.us.5 = load double, ptr %scevgep97, align 8
  %.518.us.5 = fsub double %arg.d, %.516.us.5
  %sunkaddr134 = mul i64 %.434383385.us, 8
  %sunkaddr135 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr134
  %sunkaddr136 = getelementptr i8, ptr %sunkaddr135, i64 40
  %.551.us.5 = load double, ptr %sunkaddr136, align 8
  %.553.us.5 = fcmp ogt double %.518.us.5, 0.000000e+00
  %storemerge374.us.v.5 = select i1 %.553.us.5, double %.518.us.5, double 0.000000e+00
  %storemerge374.us.5 = fadd double %.551.us.5, %storemerge374.us.v.5
  %"$phi258.3.2.2.us.5" = zext i1 %.553.us.5 to i64
  store double %storemerge374.us.5, ptr %sunkaddr136, align 8
  %.635.us.5 = add nsw i64 %.635.us.4, %"$phi258.3.2.2.us.5"
  %64 = shl i64 %.434383385.us, 3
  %scevgep94 = getelementptr i8, ptr %lsr.iv61, i64 %64
  %scevgep95 = getelementptr i8, ptr %scevgep94, i64 48
  %.516.us.6 = load double, ptr %scevgep95, align 8
  %.518.us.6 = fsub double %arg.d, %.516.us.6
  %sunkaddr137 = mul i64 %.434383385.us, 8
  %sunkaddr138 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr137
  %sunkaddr139 = getelementptr i8, ptr %sunkaddr138, i64 48
  %.551.us.6 = load double, ptr %sunkaddr139, align 8
  %.553.us.6 = fcmp ogt double %.518.us.6, 0.000000e+00
  %storemerge374.us.v.6 = select i1 %.553.us.6, double %.518.us.6, double 0.000000e+00
  %storemerge374.us.6 = fadd double %.551.us.6, %storemerge374.us.v.6
  %"$phi258.3.2.2.us.6" = zext i1 %.553.us.6 to i64
  store double %storemerge374.us.6, ptr %sunkaddr139, align 8
  %.635.us.6 = add nsw i64 %.635.us.5, %"$phi258.3.2.2.us.6"
  %.441.us.7 = add nuw nsw i64 %.434383385.us, 8
  %65 = shl i64 %.434383385.us, 3
  %scevgep86 = getelementptr i8, ptr %lsr.iv61, i64 %65
  %scevgep87 = getelementptr i8, ptr %scevgep86, i64 56
  %.516.us.7 = load double, ptr %scevgep87, align 8
  %.518.us.7 = fsub double %arg.d, %.516.us.7
  %sunkaddr140 = mul i64 %.434383385.us, 8
  %sunkaddr141 = getelementptr i8, ptr %arg.sums.4, i64 %sunkaddr140
  %sunkaddr142 = getelementptr i8, ptr %sunkaddr141, i64 56
  %.551.us.7 = load double, ptr %sunkaddr142, align 8
  %.553.us.7 = fcmp ogt double %.518.us.7, 0.000000e+00
  %storemerge374.us.v.7 = select i1 %.553.us.7, double %.518.us.7, double 0.000000e+00
  %storemerge374.us.7 = fadd double %.551.us.7, %storemerge374.us.v.7
  %"$phi258.3.2.2.us.7" = zext i1 %.553.us.7 to i64
  store double %storemerge374.us.7, ptr %sunkaddr142, align 8
  %.635.us.7 = add nsw i64 %.635.us.6, %"$phi258.3.2.2.us.7"
  %exitcond420.not.7 = icmp eq i64 %arg.sums.2, %.441.us.7
  br i1 %exitcond420.not.7, label %B160.B116.loopexit_crit_edge.us, label %B162.us, !llvm.loop !298

B160.B116.loopexit_crit_edge.us:                  ; preds = %B162.us, %B162.us.prol.loopexit, %vec.epilog.middle.block, %middle.block
  %.635.us.lcssa = phi i64 [ %52, %vec.epilog.middle.block ], [ %38, %middle.block ], [ %.635.us.lcssa69.unr, %B162.us.prol.loopexit ], [ %.635.us.7, %B162.us ]
  %.308.us = add nuw nsw i64 %.301392398.us, 1
  %scevgep55 = getelementptr i8, ptr %lsr.iv, i64 %6
  %scevgep62 = getelementptr i8, ptr %lsr.iv61, i64 %6
  %exitcond421.not = icmp eq i64 %.308.us, %arg.c.5.0
  br i1 %exitcond421.not, label %B268.else.if.loopexit419, label %iter.check

B268.else.if.loopexit419:                         ; preds = %B160.B116.loopexit_crit_edge.us
  %66 = sitofp i64 %.635.us.lcssa to double
  br label %B268.else.if

B268.else.if:                                     ; preds = %B268.else.if.loopexit419, %B50.preheader, %B0.endif
  %touching.3.0.lcssa = phi double [ 0.000000e+00, %B50.preheader ], [ %66, %B268.else.if.loopexit419 ], [ 0.000000e+00, %B0.endif ]
  %.677.1 = ashr i64 %arg.sums.2, 1
  %.713 = icmp sgt i64 %.677.1, 0
  br i1 %.713, label %iter.check31.preheader, label %B408

iter.check31.preheader:                           ; preds = %B268.else.if
  %scevgep35 = getelementptr i8, ptr %arg.sums.4, i64 192
  br label %iter.check31

iter.check31:                                     ; preds = %iter.check31.preheader, %B386.endif
  %half.2.0 = phi i64 [ %.953370, %B386.endif ], [ %.677.1, %iter.check31.preheader ]
  %invariant.gep = getelementptr double, ptr %arg.sums.4, i64 %half.2.0
  %min.iters.check29 = icmp samesign ult i64 %half.2.0, 4
  br i1 %min.iters.check29, label %B332.preheader, label %vector.main.loop.iter.check33

B332.preheader:                                   ; preds = %vec.epilog.middle.block62, %vec.epilog.iter.check52, %iter.check31
  %.804411413.ph = phi i64 [ 0, %iter.check31 ], [ %n.vec36, %vec.epilog.iter.check52 ], [ %n.vec56, %vec.epilog.middle.block62 ]
  br label %B332

vector.main.loop.iter.check33:                    ; preds = %iter.check31
  %min.iters.check32 = icmp samesign ult i64 %half.2.0, 32
  br i1 %min.iters.check32, label %vec.epilog.ph54, label %vector.ph34

vector.ph34:                                      ; preds = %vector.main.loop.iter.check33
  %n.vec36 = and i64 %half.2.0, %const
  %67 = shl i64 %half.2.0, 3
  %scevgep36 = getelementptr i8, ptr %scevgep35, i64 %67
  br label %vector.body37

vector.body37:                                    ; preds = %vector.body37, %vector.ph34
  %index38 = phi i64 [ 0, %vector.ph34 ], [ %index.next47, %vector.body37 ]
  %68 = shl i64 %index38, 3
  %scevgep41 = getelementptr i8, ptr %scevgep35, i64 %68
  %scevgep42 = getelementptr i8, ptr %scevgep41, i64 -192
  %scevgep44 = getelementptr i8, ptr %scevgep41, i64 -128
  %scevgep43 = getelementptr i8, ptr %scevgep41, i64 -64
  %wide.load39 = load <8 x double>, ptr %scevgep42, align 8
  %wide.load40 = load <8 x double>, ptr %scevgep44, align 8
  %wide.load41 = load <8 x double>, ptr %scevgep43, align 8
  %wide.load42 = load <8 x double>, ptr %scevgep41, align 8
  %69 = shl i64 %index38, 3
  %scevgep37 = getelementptr i8, ptr %scevgep36, i64 %69
  %scevgep38 = getelementptr i8, ptr %scevgep37, i64 -192
  %scevgep40 = getelementptr i8, ptr %scevgep37, i64 -128
  %scevgep39 = getelementptr i8, ptr %scevgep37, i64 -64
  %wide.load43 = load <8 x double>, ptr %scevgep38, align 8
  %wide.load44 = load <8 x double>, ptr %scevgep40, align 8
  %wide.load45 = load <8 x double>, ptr %scevgep39, align 8
  %wide.load46 = load <8 x double>, ptr %scevgep37, align 8
  %70 = fadd <8 x double> %wide.load39, %wide.load43
  %71 = fadd <8 x double> %wide.load40, %wide.load44
  %72 = fadd <8 x double> %wide.load41, %wide.load45
  %73 = fadd <8 x double> %wide.load42, %wide.load46
  store <8 x double> %70, ptr %scevgep42, align 8
  store <8 x double> %71, ptr %scevgep44, align 8
  store <8 x double> %72, ptr %scevgep43, align 8
  store <8 x double> %73, ptr %scevgep41, align 8
  %index.next47 = add nuw i64 %index38, 32
  %74 = icmp eq i64 %n.vec36, %index.next47
  br i1 %74, label %middle.block48, label %vector.body37, !llvm.loop !299

middle.block48:                                   ; preds = %vector.body37
  %cmp.n49 = icmp eq i64 %half.2.0, %n.vec36
  br i1 %cmp.n49, label %B386.endif, label %vec.epilog.iter.check52

vec.epilog.iter.check52:                          ; preds = %middle.block48
  %n.mod.vf35 = and i64 %half.2.0, 28
  %min.epilog.iters.check53 = icmp eq i64 %n.mod.vf35, 0
  br i1 %min.epilog.iters.check53, label %B332.preheader, label %vec.epilog.ph54, !prof !91

vec.epilog.ph54:                                  ; preds = %vec.epilog.iter.check52, %vector.main.loop.iter.check33
  %vec.epilog.resume.val50 = phi i64 [ %n.vec36, %vec.epilog.iter.check52 ], [ 0, %vector.main.loop.iter.check33 ]
  %const_mat98 = add i64 %const, 28
  %n.vec56 = and i64 %half.2.0, %const_mat98
  br label %vec.epilog.vector.body57

vec.epilog.vector.body57:                         ; preds = %vec.epilog.vector.body57, %vec.epilog.ph54
  %index58 = phi i64 [ %vec.epilog.resume.val50, %vec.epilog.ph54 ], [ %index.next61, %vec.epilog.vector.body57 ]
  %75 = shl i64 %index58, 3
  %scevgep46 = getelementptr i8, ptr %arg.sums.4, i64 %75
  %wide.load59 = load <4 x double>, ptr %scevgep46, align 8
  %76 = shl i64 %index58, 3
  %scevgep45 = getelementptr i8, ptr %invariant.gep, i64 %76
  %wide.load60 = load <4 x double>, ptr %scevgep45, align 8
  %77 = fadd <4 x double> %wide.load59, %wide.load60
  store <4 x double> %77, ptr %scevgep46, align 8
  %index.next61 = add nuw i64 %index58, 4
  %78 = icmp eq i64 %n.vec56, %index.next61
  br i1 %78, label %vec.epilog.middle.block62, label %vec.epilog.vector.body57, !llvm.loop !300

vec.epilog.middle.block62:                        ; preds = %vec.epilog.vector.body57
  %cmp.n63 = icmp eq i64 %half.2.0, %n.vec56
  br i1 %cmp.n63, label %B386.endif, label %B332.preheader

B386.endif:                                       ; preds = %B332, %vec.epilog.middle.block62, %middle.block48
  %.953370 = lshr i64 %half.2.0, 1
  %.977.not = icmp eq i64 %.953370, 0
  br i1 %.977.not, label %B408, label %iter.check31
}

define linkonce_odr range(i32 0, 2) i32 @_ZN18elastomer_friction7kernels5model7contact22_lowest_of_spring_rowsB3v53B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29d(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, ptr %arg.contact.0.0, ptr readnone captures(none) %arg.contact.0.1, i64 %arg.contact.0.2, i64 %arg.contact.0.3, ptr %arg.contact.0.4, i64 %arg.contact.0.5.0, i64 %arg.contact.0.5.1, i64 %arg.contact.0.6.0, i64 %arg.contact.0.6.1, ptr %arg.contact.1.0, ptr readnone captures(none) %arg.contact.1.1, i64 %arg.contact.1.2, i64 %arg.contact.1.3, ptr readnone captures(none) %arg.contact.1.4, i64 %arg.contact.1.5.0, i64 %arg.contact.1.6.0, ptr %arg.contact.2.0, ptr readnone captures(none) %arg.contact.2.1, i64 %arg.contact.2.2, i64 %arg.contact.2.3, ptr readnone captures(none) %arg.contact.2.4, i64 %arg.contact.2.5.0, i64 %arg.contact.2.6.0, double %arg.load) local_unnamed_addr {
B0:
  %.101 = alloca double, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  tail call void @NRT_incref(ptr %arg.contact.0.0)
  tail call void @NRT_incref(ptr %arg.contact.1.0)
  tail call void @NRT_incref(ptr %arg.contact.2.0)
  %.69 = icmp sgt i64 %arg.contact.0.2, 0
  br i1 %.69, label %B36, label %B86

B36:                                              ; preds = %B0
  store double 0.000000e+00, ptr %.101, align 8
  %.109 = call i32 @_ZN5numba2np9arraymath7npy_min12_3clocals_3e8impl_minB3v54B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi2E1C7mutable7alignedE(ptr nonnull %.101, ptr nonnull %excinfo.1, ptr %arg.contact.0.0, ptr %arg.contact.0.1, i64 %arg.contact.0.2, i64 %arg.contact.0.3, ptr %arg.contact.0.4, i64 %arg.contact.0.5.0, i64 %arg.contact.0.5.1, i64 %arg.contact.0.6.0, i64 %arg.contact.0.6.1)
  tail call void @NRT_decref(ptr %arg.contact.1.0)
  tail call void @NRT_decref(ptr %arg.contact.2.0)
  %cond = icmp eq i32 %.109, 0
  br i1 %cond, label %B36.endif, label %B36.if.if, !prof !0

B86:                                              ; preds = %B0
  tail call void @NRT_decref(ptr %arg.contact.0.0)
  tail call void @NRT_decref(ptr %arg.contact.1.0)
  br label %B108

common.ret:                                       ; preds = %B36.if.if, %B108
  %common.ret.op = phi i32 [ 0, %B108 ], [ 1, %B36.if.if ]
  ret i32 %common.ret.op

B108:                                             ; preds = %B36.endif, %B86
  %arg.contact.0.0.sink = phi ptr [ %arg.contact.0.0, %B36.endif ], [ %arg.contact.2.0, %B86 ]
  %"$phi108.0.2.0" = phi double [ %.119, %B36.endif ], [ 0x7FF0000000000000, %B86 ]
  tail call void @NRT_decref(ptr %arg.contact.0.0.sink)
  %.160 = fadd double %arg.load, %"$phi108.0.2.0"
  store double %"$phi108.0.2.0", ptr %retptr, align 8
  %retptr.repack98 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store double %.160, ptr %retptr.repack98, align 8
  br label %common.ret

B36.endif:                                        ; preds = %B36
  %.119 = load double, ptr %.101, align 8
  br label %B108

B36.if.if:                                        ; preds = %B36
  %.110 = load ptr, ptr %excinfo.1, align 8
  store ptr %.110, ptr %excinfo, align 8
  br label %common.ret
}

; Function Attrs: nofree nounwind memory(read)
declare double @numba_nextafter(double, double) local_unnamed_addr #12

define linkonce_odr range(i32 0, 2) i32 @_ZN5numba2np9arraymath7npy_min12_3clocals_3e8impl_minB3v54B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi2E1C7mutable7alignedE(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, ptr %arg.a.0, ptr readnone captures(none) %arg.a.1, i64 %arg.a.2, i64 %arg.a.3, ptr %arg.a.4, i64 %arg.a.5.0, i64 %arg.a.5.1, i64 %arg.a.6.0, i64 %arg.a.6.1) local_unnamed_addr {
B0:
  %.19.i.i = alloca { ptr, ptr, i64, i64, ptr, [0 x i64], [0 x i64] }, align 8
  %.23.i.i = alloca [1 x i64], align 8
  %.79.i.i = alloca [1 x i64], align 8
  tail call void @NRT_incref(ptr %arg.a.0)
  %.31 = icmp eq i64 %arg.a.2, 0
  br i1 %.31, label %B28, label %B58.endif

common.ret:                                       ; preds = %end.endif.endif.if.if, %B300.critedge, %B262, %B188, %B28
  %common.ret.op = phi i32 [ 1, %B28 ], [ 0, %B188 ], [ 0, %B262 ], [ 0, %B300.critedge ], [ 1, %end.endif.endif.if.if ]
  ret i32 %common.ret.op

B28:                                              ; preds = %B0
  tail call void @NRT_decref(ptr %arg.a.0)
  store ptr @.const.picklebuf.917b4fd376f3111025427fa1537059f6520d9ca7.11, ptr %excinfo, align 8, !numba_exception_output !216
  br label %common.ret

B188:                                             ; preds = %end.endif.endif.endif
  tail call void @NRT_decref(ptr %arg.a.0)
  store double %.119.i, ptr %retptr, align 8
  br label %common.ret

B192:                                             ; preds = %end.endif.endif.endif
  %0 = icmp sgt i64 %arg.a.2, 1
  br i1 %0, label %B196.endif.preheader, label %B300.critedge, !prof !107

B196.endif.preheader:                             ; preds = %B192
  br label %B196.endif

B262:                                             ; preds = %B196.endif
  tail call void @NRT_decref(ptr %arg.a.0)
  store double %.469, ptr %retptr, align 8
  br label %common.ret

B196.backedge:                                    ; preds = %B196.endif
  %.415 = add nuw i64 %.415301305, 1
  %.6.i.inv = fcmp olt double %.469, %min_value.2.0306
  %min_value.2.0..469 = select i1 %.6.i.inv, double %.469, double %min_value.2.0306
  %exitcond.not = icmp eq i64 %arg.a.2, %.415
  br i1 %exitcond.not, label %B300.critedge, label %B196.endif, !prof !217

B300.critedge:                                    ; preds = %B196.backedge, %B192
  %min_value.2.0.lcssa = phi double [ %.119.i, %B192 ], [ %min_value.2.0..469, %B196.backedge ]
  store double %min_value.2.0.lcssa, ptr %retptr, align 8
  tail call void @NRT_decref(ptr %arg.a.0)
  br label %common.ret

B58.endif:                                        ; preds = %B0
  %.206 = icmp sgt i64 %arg.a.2, 1
  br i1 %.206, label %end, label %B58.endif.endif.endif, !prof !12

end:                                              ; preds = %B58.endif.endif.endif, %B58.endif
  %.106.0 = phi i64 [ 0, %B58.endif.endif.endif ], [ 1, %B58.endif ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.19.i.i), !noalias !301
  call void @llvm.lifetime.start.p0(ptr nonnull %.23.i.i), !noalias !301
  call void @llvm.lifetime.start.p0(ptr nonnull %.79.i.i), !noalias !301
  %.fca.2.gep.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i, i64 16
  %.fca.3.gep.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i, i64 24
  %.fca.4.gep.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i, i64 32
  store i64 0, ptr %.79.i.i, align 8, !noalias !305
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.19.i.i, i8 0, i64 16, i1 false)
  store i64 1, ptr %.fca.2.gep.i.i, align 8, !noalias !305
  store i64 8, ptr %.fca.3.gep.i.i, align 8, !noalias !305
  store ptr %arg.a.4, ptr %.fca.4.gep.i.i, align 8, !noalias !305
  store i64 1, ptr %.23.i.i, align 8, !noalias !305
  %.81.i.i = getelementptr inbounds nuw i8, ptr %.19.i.i, i64 40
  %.89.i.i = call i32 @numba_attempt_nocopy_reshape(i64 0, ptr nonnull %.81.i.i, ptr nonnull %.81.i.i, i64 1, ptr nonnull %.23.i.i, ptr nonnull %.79.i.i, i64 8, i32 0), !noalias !305
  %.90.i.i = icmp eq i32 %.89.i.i, 0
  br i1 %.90.i.i, label %end.endif.endif.if.if, label %end.endif.endif.endif

B58.endif.endif.endif:                            ; preds = %B58.endif
  br label %end

end.endif.endif.endif:                            ; preds = %end
  %sunkaddr = getelementptr inbounds i8, ptr %.19.i.i, i64 32
  %.101.i.i = load ptr, ptr %sunkaddr, align 8, !noalias !305
  call void @llvm.lifetime.end.p0(ptr nonnull %.19.i.i), !noalias !301
  call void @llvm.lifetime.end.p0(ptr nonnull %.23.i.i), !noalias !301
  call void @llvm.lifetime.end.p0(ptr nonnull %.79.i.i), !noalias !301
  %.119.i = load double, ptr %.101.i.i, align 8, !noalias !301
  %.278.le = fcmp uno double %.119.i, 0.000000e+00
  br i1 %.278.le, label %B188, label %B192

end.endif.endif.if.if:                            ; preds = %end
  call void @llvm.lifetime.end.p0(ptr nonnull %.19.i.i), !noalias !301
  call void @llvm.lifetime.end.p0(ptr nonnull %.23.i.i), !noalias !301
  call void @llvm.lifetime.end.p0(ptr nonnull %.79.i.i), !noalias !301
  store ptr @.const.picklebuf.dc3bba832c4c3758273d0db24b835691af3f316c.12, ptr %excinfo, align 8
  br label %common.ret

B196.endif:                                       ; preds = %B196.endif.preheader, %B196.backedge
  %min_value.2.0306 = phi double [ %min_value.2.0..469, %B196.backedge ], [ %.119.i, %B196.endif.preheader ]
  %.415301305 = phi i64 [ %.415, %B196.backedge ], [ %.106.0, %B196.endif.preheader ]
  %1 = shl i64 %.415301305, 3
  %scevgep = getelementptr i8, ptr %arg.a.4, i64 %1
  %.469 = load double, ptr %scevgep, align 8
  %.482.le = fcmp uno double %.469, 0.000000e+00
  br i1 %.482.le, label %B262, label %B196.backedge
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define linkonce_odr noundef range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels8rheology6scaled8catch_upB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.scales.0.0, ptr readnone captures(none) %arg.scales.0.1, i64 %arg.scales.0.2, i64 %arg.scales.0.3, ptr readnone captures(none) %arg.scales.0.4, i64 %arg.scales.0.5.0, i64 %arg.scales.0.6.0, ptr readnone captures(none) %arg.scales.1.0, ptr readnone captures(none) %arg.scales.1.1, i64 %arg.scales.1.2, i64 %arg.scales.1.3, ptr readonly captures(none) %arg.scales.1.4, i64 %arg.scales.1.5.0, i64 %arg.scales.1.6.0, ptr readnone captures(none) %arg.scales.2.0, ptr readnone captures(none) %arg.scales.2.1, i64 %arg.scales.2.2, i64 %arg.scales.2.3, ptr readonly captures(none) %arg.scales.2.4, i64 %arg.scales.2.5.0, i64 %arg.scales.2.6.0, ptr readnone captures(none) %arg.scales.3.0, ptr readnone captures(none) %arg.scales.3.1, i64 %arg.scales.3.2, i64 %arg.scales.3.3, ptr readnone captures(none) %arg.scales.3.4, i64 %arg.scales.3.5.0, i64 %arg.scales.3.6.0, ptr readnone captures(none) %arg.scales.4.0, ptr readnone captures(none) %arg.scales.4.1, i64 %arg.scales.4.2, i64 %arg.scales.4.3, ptr readnone captures(none) %arg.scales.4.4, i64 %arg.scales.4.5.0, i64 %arg.scales.4.6.0, ptr readnone captures(none) %arg.scales.5.0, ptr readnone captures(none) %arg.scales.5.1, i64 %arg.scales.5.2, i64 %arg.scales.5.3, ptr readnone captures(none) %arg.scales.5.4, i64 %arg.scales.5.5.0, i64 %arg.scales.5.6.0, ptr readnone captures(none) %arg.memory.0, ptr readnone captures(none) %arg.memory.1, i64 %arg.memory.2, i64 %arg.memory.3, ptr captures(none) %arg.memory.4, i64 %arg.memory.5.0, i64 %arg.memory.5.1, i64 %arg.memory.5.2, i64 %arg.memory.6.0, i64 %arg.memory.6.1, i64 %arg.memory.6.2, ptr readnone captures(none) %arg.seen.0, ptr readnone captures(none) %arg.seen.1, i64 %arg.seen.2, i64 %arg.seen.3, ptr captures(none) %arg.seen.4, i64 %arg.seen.5.0, i64 %arg.seen.6.0, ptr readnone captures(none) %arg.some.0, ptr readnone captures(none) %arg.some.1, i64 %arg.some.2, i64 %arg.some.3, ptr readonly captures(none) %arg.some.4, i64 %arg.some.5.0, i64 %arg.some.6.0, i64 %arg.step) local_unnamed_addr #9 {
B0:
  %arg.scales.1.2.fr = freeze i64 %arg.scales.1.2
  %.139459 = icmp sgt i64 %arg.some.5.0, 0
  br i1 %.139459, label %B10.lr.ph, label %common.ret

B10.lr.ph:                                        ; preds = %B0
  %.326440.not475 = icmp slt i64 %arg.scales.1.2.fr, 1
  br i1 %.326440.not475, label %B10.us.preheader, label %B10.preheader

B10.preheader:                                    ; preds = %B10.lr.ph
  %scevgep21 = getelementptr i8, ptr %arg.memory.4, i64 448
  %0 = mul i64 %arg.memory.5.2, %arg.memory.5.1
  %1 = shl i64 %0, 3
  %2 = shl i64 %arg.memory.5.2, 3
  br label %B10

B10.us.preheader:                                 ; preds = %B10.lr.ph
  %xtraiter = and i64 %arg.some.5.0, 7
  %3 = icmp samesign ult i64 %arg.some.5.0, 8
  br i1 %3, label %B10.us.epil.preheader, label %B10.us.preheader.new

B10.us.preheader.new:                             ; preds = %B10.us.preheader
  %unroll_iter = and i64 %arg.some.5.0, 9223372036854775800
  %4 = shl i64 %arg.some.6.0, 3
  br label %B10.us

B10.us:                                           ; preds = %B10.us, %B10.us.preheader.new
  %lsr.iv12 = phi ptr [ %scevgep13, %B10.us ], [ %arg.some.4, %B10.us.preheader.new ]
  %lsr.iv10 = phi i64 [ %lsr.iv.next11, %B10.us ], [ %unroll_iter, %B10.us.preheader.new ]
  %.157.us = load i64, ptr %lsr.iv12, align 8
  %.202.us = icmp slt i64 %.157.us, 0
  %.203.us = select i1 %.202.us, i64 %arg.seen.5.0, i64 0
  %5 = getelementptr i64, ptr %arg.seen.4, i64 %.157.us
  %.217.us = getelementptr i64, ptr %5, i64 %.203.us
  %.218.us = load i64, ptr %.217.us, align 8
  %.11.i.us = tail call i64 @llvm.smax.i64(i64 %arg.step, i64 %.218.us)
  store i64 %.11.i.us, ptr %.217.us, align 8
  %scevgep14 = getelementptr i8, ptr %lsr.iv12, i64 %arg.some.6.0
  %.157.us.1 = load i64, ptr %scevgep14, align 8
  %.202.us.1 = icmp slt i64 %.157.us.1, 0
  %.203.us.1 = select i1 %.202.us.1, i64 %arg.seen.5.0, i64 0
  %6 = getelementptr i64, ptr %arg.seen.4, i64 %.157.us.1
  %.217.us.1 = getelementptr i64, ptr %6, i64 %.203.us.1
  %.218.us.1 = load i64, ptr %.217.us.1, align 8
  %.11.i.us.1 = tail call i64 @llvm.smax.i64(i64 %arg.step, i64 %.218.us.1)
  store i64 %.11.i.us.1, ptr %.217.us.1, align 8
  %scevgep15 = getelementptr i8, ptr %scevgep14, i64 %arg.some.6.0
  %.157.us.2 = load i64, ptr %scevgep15, align 8
  %.202.us.2 = icmp slt i64 %.157.us.2, 0
  %.203.us.2 = select i1 %.202.us.2, i64 %arg.seen.5.0, i64 0
  %7 = getelementptr i64, ptr %arg.seen.4, i64 %.157.us.2
  %.217.us.2 = getelementptr i64, ptr %7, i64 %.203.us.2
  %.218.us.2 = load i64, ptr %.217.us.2, align 8
  %.11.i.us.2 = tail call i64 @llvm.smax.i64(i64 %arg.step, i64 %.218.us.2)
  store i64 %.11.i.us.2, ptr %.217.us.2, align 8
  %scevgep16 = getelementptr i8, ptr %scevgep15, i64 %arg.some.6.0
  %.157.us.3 = load i64, ptr %scevgep16, align 8
  %.202.us.3 = icmp slt i64 %.157.us.3, 0
  %.203.us.3 = select i1 %.202.us.3, i64 %arg.seen.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.seen.4, i64 %.157.us.3
  %.217.us.3 = getelementptr i64, ptr %8, i64 %.203.us.3
  %.218.us.3 = load i64, ptr %.217.us.3, align 8
  %.11.i.us.3 = tail call i64 @llvm.smax.i64(i64 %arg.step, i64 %.218.us.3)
  store i64 %.11.i.us.3, ptr %.217.us.3, align 8
  %scevgep17 = getelementptr i8, ptr %scevgep16, i64 %arg.some.6.0
  %.157.us.4 = load i64, ptr %scevgep17, align 8
  %.202.us.4 = icmp slt i64 %.157.us.4, 0
  %.203.us.4 = select i1 %.202.us.4, i64 %arg.seen.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.seen.4, i64 %.157.us.4
  %.217.us.4 = getelementptr i64, ptr %9, i64 %.203.us.4
  %.218.us.4 = load i64, ptr %.217.us.4, align 8
  %.11.i.us.4 = tail call i64 @llvm.smax.i64(i64 %arg.step, i64 %.218.us.4)
  store i64 %.11.i.us.4, ptr %.217.us.4, align 8
  %scevgep18 = getelementptr i8, ptr %scevgep17, i64 %arg.some.6.0
  %.157.us.5 = load i64, ptr %scevgep18, align 8
  %.202.us.5 = icmp slt i64 %.157.us.5, 0
  %.203.us.5 = select i1 %.202.us.5, i64 %arg.seen.5.0, i64 0
  %10 = getelementptr i64, ptr %arg.seen.4, i64 %.157.us.5
  %.217.us.5 = getelementptr i64, ptr %10, i64 %.203.us.5
  %.218.us.5 = load i64, ptr %.217.us.5, align 8
  %.11.i.us.5 = tail call i64 @llvm.smax.i64(i64 %arg.step, i64 %.218.us.5)
  store i64 %.11.i.us.5, ptr %.217.us.5, align 8
  %scevgep19 = getelementptr i8, ptr %scevgep18, i64 %arg.some.6.0
  %.157.us.6 = load i64, ptr %scevgep19, align 8
  %.202.us.6 = icmp slt i64 %.157.us.6, 0
  %.203.us.6 = select i1 %.202.us.6, i64 %arg.seen.5.0, i64 0
  %11 = getelementptr i64, ptr %arg.seen.4, i64 %.157.us.6
  %.217.us.6 = getelementptr i64, ptr %11, i64 %.203.us.6
  %.218.us.6 = load i64, ptr %.217.us.6, align 8
  %.11.i.us.6 = tail call i64 @llvm.smax.i64(i64 %arg.step, i64 %.218.us.6)
  store i64 %.11.i.us.6, ptr %.217.us.6, align 8
  %scevgep20 = getelementptr i8, ptr %scevgep19, i64 %arg.some.6.0
  %.157.us.7 = load i64, ptr %scevgep20, align 8
  %.202.us.7 = icmp slt i64 %.157.us.7, 0
  %.203.us.7 = select i1 %.202.us.7, i64 %arg.seen.5.0, i64 0
  %12 = getelementptr i64, ptr %arg.seen.4, i64 %.157.us.7
  %.217.us.7 = getelementptr i64, ptr %12, i64 %.203.us.7
  %.218.us.7 = load i64, ptr %.217.us.7, align 8
  %.11.i.us.7 = tail call i64 @llvm.smax.i64(i64 %arg.step, i64 %.218.us.7)
  store i64 %.11.i.us.7, ptr %.217.us.7, align 8
  %lsr.iv.next11 = add nsw i64 %lsr.iv10, -8
  %scevgep13 = getelementptr i8, ptr %lsr.iv12, i64 %4
  %niter.ncmp.7 = icmp eq i64 %lsr.iv.next11, 0
  br i1 %niter.ncmp.7, label %common.ret.loopexit.unr-lcssa, label %B10.us

B10:                                              ; preds = %B10.preheader, %B348.endif
  %.138452462 = phi i64 [ %.160, %B348.endif ], [ 0, %B10.preheader ]
  %.151 = mul i64 %.138452462, %arg.some.6.0
  %.155 = getelementptr i8, ptr %arg.some.4, i64 %.151
  %.157 = load i64, ptr %.155, align 8
  %.160 = add nuw nsw i64 %.138452462, 1
  %.202 = icmp slt i64 %.157, 0
  %.203 = select i1 %.202, i64 %arg.seen.5.0, i64 0
  %13 = getelementptr i64, ptr %arg.seen.4, i64 %.157
  %.217 = getelementptr i64, ptr %13, i64 %.203
  %.218 = load i64, ptr %.217, align 8
  %.220.not = icmp slt i64 %.218, %arg.step
  br i1 %.220.not, label %B92.lr.ph, label %B348.endif

B92.lr.ph:                                        ; preds = %B10
  %14 = icmp slt i64 %.157, 0
  %.663 = select i1 %14, i64 %arg.memory.5.0, i64 0
  %.664 = add i64 %.663, %.157
  %15 = mul i64 %1, %.664
  %scevgep22 = getelementptr i8, ptr %scevgep21, i64 %15
  br label %B92.us

B92.us:                                           ; preds = %B346.us, %B92.lr.ph
  %lsr.iv23 = phi ptr [ %scevgep24, %B346.us ], [ %scevgep22, %B92.lr.ph ]
  %.332433443.us = phi i64 [ 0, %B92.lr.ph ], [ %.339.us, %B346.us ]
  %.339.us = add nuw nsw i64 %.332433443.us, 1
  %16 = shl i64 %.332433443.us, 3
  %scevgep33 = getelementptr i8, ptr %arg.scales.1.4, i64 %16
  %.398.us = load i64, ptr %scevgep33, align 8
  %sunkaddr = mul i64 %.203, 8
  %sunkaddr34 = getelementptr inbounds i8, ptr %13, i64 %sunkaddr
  %.429.us = load i64, ptr %sunkaddr34, align 8
  %.430.us = icmp sgt i64 %.398.us, %.429.us
  br i1 %.430.us, label %vector.body, label %B346.us

vector.body:                                      ; preds = %B92.us
  %17 = shl i64 %.332433443.us, 3
  %scevgep32 = getelementptr i8, ptr %arg.scales.2.4, i64 %17
  %.463.us = load i64, ptr %scevgep32, align 8
  %.495.not.us = icmp sgt i64 %.463.us, %.429.us
  %spec.select425.us = select i1 %.495.not.us, double 0.000000e+00, double 0x1FF0000000000000
  %broadcast.splatinsert = insertelement <8 x double> poison, double %spec.select425.us, i64 0
  %broadcast.splat = shufflevector <8 x double> %broadcast.splatinsert, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep28 = getelementptr i8, ptr %lsr.iv23, i64 -448
  %scevgep31 = getelementptr i8, ptr %lsr.iv23, i64 -384
  %scevgep30 = getelementptr i8, ptr %lsr.iv23, i64 -320
  %scevgep29 = getelementptr i8, ptr %lsr.iv23, i64 -256
  %wide.load = load <8 x double>, ptr %scevgep28, align 8
  %wide.load4 = load <8 x double>, ptr %scevgep31, align 8
  %wide.load5 = load <8 x double>, ptr %scevgep30, align 8
  %wide.load6 = load <8 x double>, ptr %scevgep29, align 8
  %18 = fmul <8 x double> %wide.load, %broadcast.splat
  %19 = fmul <8 x double> %wide.load4, %broadcast.splat
  %20 = fmul <8 x double> %wide.load5, %broadcast.splat
  %21 = fmul <8 x double> %broadcast.splat, %wide.load6
  %22 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %18)
  %23 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %19)
  %24 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %20)
  %25 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %21)
  %26 = fcmp ogt <8 x double> %22, splat (double 0x21F0000000000000)
  %27 = fcmp ogt <8 x double> %23, splat (double 0x21F0000000000000)
  %28 = fcmp ogt <8 x double> %24, splat (double 0x21F0000000000000)
  %29 = fcmp ogt <8 x double> %25, splat (double 0x21F0000000000000)
  %30 = select <8 x i1> %26, <8 x double> %18, <8 x double> zeroinitializer
  %31 = select <8 x i1> %27, <8 x double> %19, <8 x double> zeroinitializer
  %32 = select <8 x i1> %28, <8 x double> %20, <8 x double> zeroinitializer
  %33 = select <8 x i1> %29, <8 x double> %21, <8 x double> zeroinitializer
  store <8 x double> %30, ptr %scevgep28, align 8
  store <8 x double> %31, ptr %scevgep31, align 8
  store <8 x double> %32, ptr %scevgep30, align 8
  store <8 x double> %33, ptr %scevgep29, align 8
  %scevgep27 = getelementptr i8, ptr %lsr.iv23, i64 -192
  %scevgep26 = getelementptr i8, ptr %lsr.iv23, i64 -128
  %scevgep25 = getelementptr i8, ptr %lsr.iv23, i64 -64
  %wide.load.1 = load <8 x double>, ptr %scevgep27, align 8
  %wide.load4.1 = load <8 x double>, ptr %scevgep26, align 8
  %wide.load5.1 = load <8 x double>, ptr %scevgep25, align 8
  %wide.load6.1 = load <8 x double>, ptr %lsr.iv23, align 8
  %34 = fmul <8 x double> %broadcast.splat, %wide.load.1
  %35 = fmul <8 x double> %broadcast.splat, %wide.load4.1
  %36 = fmul <8 x double> %broadcast.splat, %wide.load5.1
  %37 = fmul <8 x double> %broadcast.splat, %wide.load6.1
  %38 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %34)
  %39 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %35)
  %40 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %36)
  %41 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %37)
  %42 = fcmp ogt <8 x double> %38, splat (double 0x21F0000000000000)
  %43 = fcmp ogt <8 x double> %39, splat (double 0x21F0000000000000)
  %44 = fcmp ogt <8 x double> %40, splat (double 0x21F0000000000000)
  %45 = fcmp ogt <8 x double> %41, splat (double 0x21F0000000000000)
  %46 = select <8 x i1> %42, <8 x double> %34, <8 x double> zeroinitializer
  %47 = select <8 x i1> %43, <8 x double> %35, <8 x double> zeroinitializer
  %48 = select <8 x i1> %44, <8 x double> %36, <8 x double> zeroinitializer
  %49 = select <8 x i1> %45, <8 x double> %37, <8 x double> zeroinitializer
  store <8 x double> %46, ptr %scevgep27, align 8
  store <8 x double> %47, ptr %scevgep26, align 8
  store <8 x double> %48, ptr %scevgep25, align 8
  store <8 x double> %49, ptr %lsr.iv23, align 8
  br label %B346.us

B346.us:                                          ; preds = %vector.body, %B92.us
  %scevgep24 = getelementptr i8, ptr %lsr.iv23, i64 %2
  %exitcond472.not = icmp eq i64 %arg.scales.1.2.fr, %.339.us
  br i1 %exitcond472.not, label %B348.loopexit, label %B92.us

B348.loopexit:                                    ; preds = %B346.us
  %sunkaddr35 = mul i64 %.203, 8
  %sunkaddr36 = getelementptr i8, ptr %13, i64 %sunkaddr35
  %.844.pre = load i64, ptr %sunkaddr36, align 8
  br label %B348.endif

common.ret.loopexit.unr-lcssa:                    ; preds = %B10.us
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %common.ret, label %B10.us.epil.preheader

B10.us.epil.preheader:                            ; preds = %common.ret.loopexit.unr-lcssa, %B10.us.preheader
  %.138452462.us.epil.init = phi i64 [ 0, %B10.us.preheader ], [ %unroll_iter, %common.ret.loopexit.unr-lcssa ]
  %50 = mul i64 %.138452462.us.epil.init, %arg.some.6.0
  %scevgep = getelementptr i8, ptr %arg.some.4, i64 %50
  br label %B10.us.epil

B10.us.epil:                                      ; preds = %B10.us.epil, %B10.us.epil.preheader
  %lsr.iv9 = phi i64 [ %lsr.iv.next, %B10.us.epil ], [ %xtraiter, %B10.us.epil.preheader ]
  %lsr.iv = phi ptr [ %scevgep8, %B10.us.epil ], [ %scevgep, %B10.us.epil.preheader ]
  %.157.us.epil = load i64, ptr %lsr.iv, align 8
  %.202.us.epil = icmp slt i64 %.157.us.epil, 0
  %.203.us.epil = select i1 %.202.us.epil, i64 %arg.seen.5.0, i64 0
  %51 = getelementptr i64, ptr %arg.seen.4, i64 %.157.us.epil
  %.217.us.epil = getelementptr i64, ptr %51, i64 %.203.us.epil
  %.218.us.epil = load i64, ptr %.217.us.epil, align 8
  %.11.i.us.epil = tail call i64 @llvm.smax.i64(i64 %arg.step, i64 %.218.us.epil)
  store i64 %.11.i.us.epil, ptr %.217.us.epil, align 8
  %scevgep8 = getelementptr i8, ptr %lsr.iv, i64 %arg.some.6.0
  %lsr.iv.next = add nsw i64 %lsr.iv9, -1
  %epil.iter.cmp.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %epil.iter.cmp.not, label %common.ret, label %B10.us.epil, !llvm.loop !309

common.ret:                                       ; preds = %B348.endif, %B10.us.epil, %common.ret.loopexit.unr-lcssa, %B0
  store ptr null, ptr %retptr, align 8
  ret i32 0

B348.endif:                                       ; preds = %B348.loopexit, %B10
  %.844 = phi i64 [ %.218, %B10 ], [ %.844.pre, %B348.loopexit ]
  %.11.i = tail call i64 @llvm.smax.i64(i64 %arg.step, i64 %.844)
  %sunkaddr37 = mul i64 %.203, 8
  %sunkaddr38 = getelementptr i8, ptr %13, i64 %sunkaddr37
  store i64 %.11.i, ptr %sunkaddr38, align 8
  %exitcond473.not = icmp eq i64 %.160, %arg.some.5.0
  br i1 %exitcond473.not, label %common.ret, label %B10
}

; Function Attrs: nofree norecurse nosync nounwind memory(write, argmem: readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define linkonce_odr range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels8rheology6scaled18settle_and_predictB3v44B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, ptr readnone captures(none) %arg.law.0.0, ptr readnone captures(none) %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr readnone captures(none) %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr readnone captures(none) %arg.law.1.0, ptr readnone captures(none) %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr readnone captures(none) %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr readnone captures(none) %arg.law.2.0, ptr readnone captures(none) %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr readonly captures(none) %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr readnone captures(none) %arg.scales.0.0, ptr readnone captures(none) %arg.scales.0.1, i64 %arg.scales.0.2, i64 %arg.scales.0.3, ptr readnone captures(none) %arg.scales.0.4, i64 %arg.scales.0.5.0, i64 %arg.scales.0.6.0, ptr readnone captures(none) %arg.scales.1.0, ptr readnone captures(none) %arg.scales.1.1, i64 %arg.scales.1.2, i64 %arg.scales.1.3, ptr readnone captures(none) %arg.scales.1.4, i64 %arg.scales.1.5.0, i64 %arg.scales.1.6.0, ptr readnone captures(none) %arg.scales.2.0, ptr readnone captures(none) %arg.scales.2.1, i64 %arg.scales.2.2, i64 %arg.scales.2.3, ptr readnone captures(none) %arg.scales.2.4, i64 %arg.scales.2.5.0, i64 %arg.scales.2.6.0, ptr readnone captures(none) %arg.scales.3.0, ptr readnone captures(none) %arg.scales.3.1, i64 %arg.scales.3.2, i64 %arg.scales.3.3, ptr readonly captures(none) %arg.scales.3.4, i64 %arg.scales.3.5.0, i64 %arg.scales.3.6.0, ptr readnone captures(none) %arg.scales.4.0, ptr readnone captures(none) %arg.scales.4.1, i64 %arg.scales.4.2, i64 %arg.scales.4.3, ptr readonly captures(none) %arg.scales.4.4, i64 %arg.scales.4.5.0, i64 %arg.scales.4.6.0, ptr readnone captures(none) %arg.scales.5.0, ptr readnone captures(none) %arg.scales.5.1, i64 %arg.scales.5.2, i64 %arg.scales.5.3, ptr readonly captures(none) %arg.scales.5.4, i64 %arg.scales.5.5.0, i64 %arg.scales.5.6.0, ptr readnone captures(none) %arg.memory.0, ptr readnone captures(none) %arg.memory.1, i64 %arg.memory.2, i64 %arg.memory.3, ptr captures(address) %arg.memory.4, i64 %arg.memory.5.0, i64 %arg.memory.5.1, i64 %arg.memory.5.2, i64 %arg.memory.6.0, i64 %arg.memory.6.1, i64 %arg.memory.6.2, ptr readnone captures(none) %arg.pressed.0, ptr readnone captures(none) %arg.pressed.1, i64 %arg.pressed.2, i64 %arg.pressed.3, ptr readonly captures(none) %arg.pressed.4, i64 %arg.pressed.5.0, i64 %arg.pressed.6.0, ptr readnone captures(none) %arg.p.0, ptr readnone captures(none) %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr readonly captures(none) %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1, ptr readnone captures(none) %arg.older.0, ptr readnone captures(none) %arg.older.1, i64 %arg.older.2, i64 %arg.older.3, ptr readonly captures(none) %arg.older.4, i64 %arg.older.5.0, i64 %arg.older.5.1, i64 %arg.older.6.0, i64 %arg.older.6.1, ptr readnone captures(none) %arg.some.0, ptr readnone captures(none) %arg.some.1, i64 %arg.some.2, i64 %arg.some.3, ptr readonly captures(none) %arg.some.4, i64 %arg.some.5.0, i64 %arg.some.6.0, ptr readnone captures(none) %arg.z.0, ptr readnone captures(none) %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr readonly captures(none) %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, ptr readnone captures(none) %arg.total.0, ptr readnone captures(none) %arg.total.1, i64 %arg.total.2, i64 %arg.total.3, ptr captures(address) %arg.total.4, i64 %arg.total.5.0, i64 %arg.total.6.0, ptr readnone captures(none) %arg.c.0, ptr readnone captures(none) %arg.c.1, i64 %arg.c.2, i64 %arg.c.3, ptr writeonly captures(none) %arg.c.4, i64 %arg.c.5.0, i64 %arg.c.5.1, i64 %arg.c.6.0, i64 %arg.c.6.1) local_unnamed_addr #11 {
B0.endif:
  %.948 = alloca ptr, align 8
  %excinfo.1 = alloca ptr, align 8
  %.292817.not = icmp slt i64 %arg.law.2.2, 1
  br i1 %.292817.not, label %B96.endif, label %B60.preheader

B60.preheader:                                    ; preds = %B0.endif
  %xtraiter = and i64 %arg.law.2.2, 7
  %0 = icmp samesign ult i64 %arg.law.2.2, 8
  br i1 %0, label %B60.epil.preheader, label %B60.preheader.new

B60.preheader.new:                                ; preds = %B60.preheader
  %const = bitcast i64 9223372036854775776 to i64
  %const_mat = add i64 %const, 24
  %unroll_iter = and i64 %arg.law.2.2, %const_mat
  %1 = add nsw i64 %arg.law.2.2, -8
  %2 = lshr i64 %1, 3
  %3 = add nuw nsw i64 %2, 1
  %xtraiter48 = and i64 %3, 3
  %4 = icmp samesign ult i64 %arg.law.2.2, 32
  br i1 %4, label %B60.epil.preheader47, label %B60.preheader.new.new

B60.preheader.new.new:                            ; preds = %B60.preheader.new
  %unroll_iter59 = and i64 %3, 4611686018427387900
  %scevgep320 = getelementptr i8, ptr %arg.law.2.4, i64 248
  br label %B60

B60:                                              ; preds = %B60, %B60.preheader.new.new
  %lsr.iv354 = phi i64 [ %lsr.iv.next355, %B60 ], [ %unroll_iter59, %B60.preheader.new.new ]
  %lsr.iv321 = phi ptr [ %scevgep322, %B60 ], [ %scevgep320, %B60.preheader.new.new ]
  %now.2.0820 = phi double [ 0.000000e+00, %B60.preheader.new.new ], [ %.362.7.3, %B60 ]
  %scevgep353 = getelementptr i8, ptr %lsr.iv321, i64 -248
  %.360 = load double, ptr %scevgep353, align 8
  %.362 = fadd double %now.2.0820, %.360
  %scevgep352 = getelementptr i8, ptr %lsr.iv321, i64 -240
  %.360.1 = load double, ptr %scevgep352, align 8
  %.362.1 = fadd double %.362, %.360.1
  %scevgep351 = getelementptr i8, ptr %lsr.iv321, i64 -232
  %.360.2 = load double, ptr %scevgep351, align 8
  %.362.2 = fadd double %.362.1, %.360.2
  %scevgep350 = getelementptr i8, ptr %lsr.iv321, i64 -224
  %.360.3 = load double, ptr %scevgep350, align 8
  %.362.3 = fadd double %.362.2, %.360.3
  %scevgep349 = getelementptr i8, ptr %lsr.iv321, i64 -216
  %.360.4 = load double, ptr %scevgep349, align 8
  %.362.4 = fadd double %.362.3, %.360.4
  %scevgep348 = getelementptr i8, ptr %lsr.iv321, i64 -208
  %.360.5 = load double, ptr %scevgep348, align 8
  %.362.5 = fadd double %.362.4, %.360.5
  %scevgep347 = getelementptr i8, ptr %lsr.iv321, i64 -200
  %.360.6 = load double, ptr %scevgep347, align 8
  %.362.6 = fadd double %.362.5, %.360.6
  %scevgep346 = getelementptr i8, ptr %lsr.iv321, i64 -192
  %.360.7 = load double, ptr %scevgep346, align 8
  %.362.7 = fadd double %.362.6, %.360.7
  %scevgep345 = getelementptr i8, ptr %lsr.iv321, i64 -184
  %.360.160 = load double, ptr %scevgep345, align 8
  %.362.161 = fadd double %.362.7, %.360.160
  %scevgep344 = getelementptr i8, ptr %lsr.iv321, i64 -176
  %.360.1.1 = load double, ptr %scevgep344, align 8
  %.362.1.1 = fadd double %.362.161, %.360.1.1
  %scevgep343 = getelementptr i8, ptr %lsr.iv321, i64 -168
  %.360.2.1 = load double, ptr %scevgep343, align 8
  %.362.2.1 = fadd double %.362.1.1, %.360.2.1
  %scevgep342 = getelementptr i8, ptr %lsr.iv321, i64 -160
  %.360.3.1 = load double, ptr %scevgep342, align 8
  %.362.3.1 = fadd double %.362.2.1, %.360.3.1
  %scevgep341 = getelementptr i8, ptr %lsr.iv321, i64 -152
  %.360.4.1 = load double, ptr %scevgep341, align 8
  %.362.4.1 = fadd double %.362.3.1, %.360.4.1
  %scevgep340 = getelementptr i8, ptr %lsr.iv321, i64 -144
  %.360.5.1 = load double, ptr %scevgep340, align 8
  %.362.5.1 = fadd double %.362.4.1, %.360.5.1
  %scevgep339 = getelementptr i8, ptr %lsr.iv321, i64 -136
  %.360.6.1 = load double, ptr %scevgep339, align 8
  %.362.6.1 = fadd double %.362.5.1, %.360.6.1
  %scevgep338 = getelementptr i8, ptr %lsr.iv321, i64 -128
  %.360.7.1 = load double, ptr %scevgep338, align 8
  %.362.7.1 = fadd double %.362.6.1, %.360.7.1
  %scevgep337 = getelementptr i8, ptr %lsr.iv321, i64 -120
  %.360.262 = load double, ptr %scevgep337, align 8
  %.362.263 = fadd double %.362.7.1, %.360.262
  %scevgep336 = getelementptr i8, ptr %lsr.iv321, i64 -112
  %.360.1.2 = load double, ptr %scevgep336, align 8
  %.362.1.2 = fadd double %.362.263, %.360.1.2
  %scevgep335 = getelementptr i8, ptr %lsr.iv321, i64 -104
  %.360.2.2 = load double, ptr %scevgep335, align 8
  %.362.2.2 = fadd double %.362.1.2, %.360.2.2
  %scevgep334 = getelementptr i8, ptr %lsr.iv321, i64 -96
  %.360.3.2 = load double, ptr %scevgep334, align 8
  %.362.3.2 = fadd double %.362.2.2, %.360.3.2
  %scevgep333 = getelementptr i8, ptr %lsr.iv321, i64 -88
  %.360.4.2 = load double, ptr %scevgep333, align 8
  %.362.4.2 = fadd double %.362.3.2, %.360.4.2
  %scevgep332 = getelementptr i8, ptr %lsr.iv321, i64 -80
  %.360.5.2 = load double, ptr %scevgep332, align 8
  %.362.5.2 = fadd double %.362.4.2, %.360.5.2
  %scevgep331 = getelementptr i8, ptr %lsr.iv321, i64 -72
  %.360.6.2 = load double, ptr %scevgep331, align 8
  %.362.6.2 = fadd double %.362.5.2, %.360.6.2
  %scevgep330 = getelementptr i8, ptr %lsr.iv321, i64 -64
  %.360.7.2 = load double, ptr %scevgep330, align 8
  %.362.7.2 = fadd double %.362.6.2, %.360.7.2
  %scevgep329 = getelementptr i8, ptr %lsr.iv321, i64 -56
  %.360.364 = load double, ptr %scevgep329, align 8
  %.362.365 = fadd double %.362.7.2, %.360.364
  %scevgep328 = getelementptr i8, ptr %lsr.iv321, i64 -48
  %.360.1.3 = load double, ptr %scevgep328, align 8
  %.362.1.3 = fadd double %.362.365, %.360.1.3
  %scevgep327 = getelementptr i8, ptr %lsr.iv321, i64 -40
  %.360.2.3 = load double, ptr %scevgep327, align 8
  %.362.2.3 = fadd double %.362.1.3, %.360.2.3
  %scevgep326 = getelementptr i8, ptr %lsr.iv321, i64 -32
  %.360.3.3 = load double, ptr %scevgep326, align 8
  %.362.3.3 = fadd double %.362.2.3, %.360.3.3
  %scevgep325 = getelementptr i8, ptr %lsr.iv321, i64 -24
  %.360.4.3 = load double, ptr %scevgep325, align 8
  %.362.4.3 = fadd double %.362.3.3, %.360.4.3
  %scevgep324 = getelementptr i8, ptr %lsr.iv321, i64 -16
  %.360.5.3 = load double, ptr %scevgep324, align 8
  %.362.5.3 = fadd double %.362.4.3, %.360.5.3
  %scevgep323 = getelementptr i8, ptr %lsr.iv321, i64 -8
  %.360.6.3 = load double, ptr %scevgep323, align 8
  %.362.6.3 = fadd double %.362.5.3, %.360.6.3
  %.360.7.3 = load double, ptr %lsr.iv321, align 8
  %.362.7.3 = fadd double %.362.6.3, %.360.7.3
  %scevgep322 = getelementptr i8, ptr %lsr.iv321, i64 256
  %lsr.iv.next355 = add nsw i64 %lsr.iv354, -4
  %niter.ncmp.3 = icmp eq i64 %lsr.iv.next355, 0
  br i1 %niter.ncmp.3, label %B96.endif.loopexit.unr-lcssa.unr-lcssa, label %B60

B138.loopexit:                                    ; preds = %B728, %vec.epilog.middle.block, %middle.block, %B674.endif
  %scevgep219 = getelementptr i8, ptr %lsr.iv218, i64 %111
  %scevgep236 = getelementptr i8, ptr %lsr.iv235, i64 %111
  %exitcond927.not = icmp eq i64 %.472, %arg.some.2
  br i1 %exitcond927.not, label %common.ret, label %B140

B140:                                             ; preds = %B140.lr.ph, %B138.loopexit
  %lsr.iv235 = phi ptr [ %arg.c.4, %B140.lr.ph ], [ %scevgep236, %B138.loopexit ]
  %lsr.iv218 = phi ptr [ %scevgep217, %B140.lr.ph ], [ %scevgep219, %B138.loopexit ]
  %.465853896 = phi i64 [ 0, %B140.lr.ph ], [ %.472, %B138.loopexit ]
  %5 = mul i64 %.465853896, %111
  %6 = add i64 %112, %5
  %.472 = add nuw nsw i64 %.465853896, 1
  %7 = getelementptr i64, ptr %arg.some.4, i64 %.465853896
  %.530 = load i64, ptr %7, align 8
  %.548 = icmp slt i64 %.530, 0
  %.549 = select i1 %.548, i64 %arg.pressed.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.pressed.4, i64 %.530
  %.563 = getelementptr i64, ptr %8, i64 %.549
  %.564 = load i64, ptr %.563, align 8
  %.565 = icmp sgt i64 %.564, 0
  br i1 %.565, label %B224.lr.ph, label %B480

B224:                                             ; preds = %B224.preheader, %B224
  %.652831833 = phi i64 [ %.659.7, %B224 ], [ 0, %B224.preheader ]
  %9 = shl nuw nsw i64 %.652831833, 3
  %scevgep213 = getelementptr i8, ptr %scevgep201, i64 %9
  %scevgep214 = getelementptr i8, ptr %scevgep213, i64 -56
  %.736 = load double, ptr %scevgep214, align 8
  %.737 = fmul double %.736, %.685
  %sunkaddr = mul i64 %.652831833, 8
  %sunkaddr359 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr
  store double %.737, ptr %sunkaddr359, align 8
  %.818 = load double, ptr %scevgep214, align 8
  %sunkaddr360 = mul i64 %.652831833, 8
  %sunkaddr361 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr360
  %sunkaddr362 = getelementptr i8, ptr %sunkaddr361, i64 512
  store double %.818, ptr %sunkaddr362, align 8
  %10 = shl nuw nsw i64 %.652831833, 3
  %scevgep148 = getelementptr i8, ptr %scevgep136, i64 %10
  %scevgep149 = getelementptr i8, ptr %scevgep148, i64 -56
  %.900 = load double, ptr %scevgep149, align 8
  %sunkaddr363 = mul i64 %.652831833, 8
  %sunkaddr364 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr363
  %sunkaddr365 = getelementptr i8, ptr %sunkaddr364, i64 1024
  store double %.900, ptr %sunkaddr365, align 8
  %11 = shl nuw nsw i64 %.652831833, 3
  %scevgep215 = getelementptr i8, ptr %scevgep201, i64 %11
  %scevgep216 = getelementptr i8, ptr %scevgep215, i64 -48
  %.736.1 = load double, ptr %scevgep216, align 8
  %.737.1 = fmul double %.736.1, %.685
  %sunkaddr366 = mul i64 %.652831833, 8
  %sunkaddr367 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr366
  %sunkaddr368 = getelementptr i8, ptr %sunkaddr367, i64 8
  store double %.737.1, ptr %sunkaddr368, align 8
  %.818.1 = load double, ptr %scevgep216, align 8
  %sunkaddr369 = mul i64 %.652831833, 8
  %sunkaddr370 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr369
  %sunkaddr371 = getelementptr i8, ptr %sunkaddr370, i64 520
  store double %.818.1, ptr %sunkaddr371, align 8
  %12 = shl nuw nsw i64 %.652831833, 3
  %scevgep150 = getelementptr i8, ptr %scevgep136, i64 %12
  %scevgep151 = getelementptr i8, ptr %scevgep150, i64 -48
  %.900.1 = load double, ptr %scevgep151, align 8
  %sunkaddr372 = mul i64 %.652831833, 8
  %sunkaddr373 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr372
  %sunkaddr374 = getelementptr i8, ptr %sunkaddr373, i64 1032
  store double %.900.1, ptr %sunkaddr374, align 8
  %13 = shl nuw nsw i64 %.652831833, 3
  %scevgep211 = getelementptr i8, ptr %scevgep201, i64 %13
  %scevgep212 = getelementptr i8, ptr %scevgep211, i64 -40
  %.736.2 = load double, ptr %scevgep212, align 8
  %.737.2 = fmul double %.736.2, %.685
  %sunkaddr375 = mul i64 %.652831833, 8
  %sunkaddr376 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr375
  %sunkaddr377 = getelementptr i8, ptr %sunkaddr376, i64 16
  store double %.737.2, ptr %sunkaddr377, align 8
  %.818.2 = load double, ptr %scevgep212, align 8
  %sunkaddr378 = mul i64 %.652831833, 8
  %sunkaddr379 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr378
  %sunkaddr380 = getelementptr i8, ptr %sunkaddr379, i64 528
  store double %.818.2, ptr %sunkaddr380, align 8
  %14 = shl nuw nsw i64 %.652831833, 3
  %scevgep146 = getelementptr i8, ptr %scevgep136, i64 %14
  %scevgep147 = getelementptr i8, ptr %scevgep146, i64 -40
  %.900.2 = load double, ptr %scevgep147, align 8
  %sunkaddr381 = mul i64 %.652831833, 8
  %sunkaddr382 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr381
  %sunkaddr383 = getelementptr i8, ptr %sunkaddr382, i64 1040
  store double %.900.2, ptr %sunkaddr383, align 8
  %15 = shl nuw nsw i64 %.652831833, 3
  %scevgep209 = getelementptr i8, ptr %scevgep201, i64 %15
  %scevgep210 = getelementptr i8, ptr %scevgep209, i64 -32
  %.736.3 = load double, ptr %scevgep210, align 8
  %.737.3 = fmul double %.736.3, %.685
  %sunkaddr384 = mul i64 %.652831833, 8
  %sunkaddr385 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr384
  %sunkaddr386 = getelementptr i8, ptr %sunkaddr385, i64 24
  store double %.737.3, ptr %sunkaddr386, align 8
  %.818.3 = load double, ptr %scevgep210, align 8
  %sunkaddr387 = mul i64 %.652831833, 8
  %sunkaddr388 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr387
  %sunkaddr389 = getelementptr i8, ptr %sunkaddr388, i64 536
  store double %.818.3, ptr %sunkaddr389, align 8
  %16 = shl nuw nsw i64 %.652831833, 3
  %scevgep144 = getelementptr i8, ptr %scevgep136, i64 %16
  %scevgep145 = getelementptr i8, ptr %scevgep144, i64 -32
  %.900.3 = load double, ptr %scevgep145, align 8
  %sunkaddr390 = mul i64 %.652831833, 8
  %sunkaddr391 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr390
  %sunkaddr392 = getelementptr i8, ptr %sunkaddr391, i64 1048
  store double %.900.3, ptr %sunkaddr392, align 8
  %17 = shl nuw nsw i64 %.652831833, 3
  %scevgep207 = getelementptr i8, ptr %scevgep201, i64 %17
  %scevgep208 = getelementptr i8, ptr %scevgep207, i64 -24
  %.736.4 = load double, ptr %scevgep208, align 8
  %.737.4 = fmul double %.736.4, %.685
  %sunkaddr393 = mul i64 %.652831833, 8
  %sunkaddr394 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr393
  %sunkaddr395 = getelementptr i8, ptr %sunkaddr394, i64 32
  store double %.737.4, ptr %sunkaddr395, align 8
  %.818.4 = load double, ptr %scevgep208, align 8
  %sunkaddr396 = mul i64 %.652831833, 8
  %sunkaddr397 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr396
  %sunkaddr398 = getelementptr i8, ptr %sunkaddr397, i64 544
  store double %.818.4, ptr %sunkaddr398, align 8
  %18 = shl nuw nsw i64 %.652831833, 3
  %scevgep142 = getelementptr i8, ptr %scevgep136, i64 %18
  %scevgep143 = getelementptr i8, ptr %scevgep142, i64 -24
  %.900.4 = load double, ptr %scevgep143, align 8
  %sunkaddr399 = mul i64 %.652831833, 8
  %sunkaddr400 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr399
  %sunkaddr401 = getelementptr i8, ptr %sunkaddr400, i64 1056
  store double %.900.4, ptr %sunkaddr401, align 8
  %19 = shl nuw nsw i64 %.652831833, 3
  %scevgep205 = getelementptr i8, ptr %scevgep201, i64 %19
  %scevgep206 = getelementptr i8, ptr %scevgep205, i64 -16
  %.736.5 = load double, ptr %scevgep206, align 8
  %.737.5 = fmul double %.736.5, %.685
  %sunkaddr402 = mul i64 %.652831833, 8
  %sunkaddr403 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr402
  %sunkaddr404 = getelementptr i8, ptr %sunkaddr403, i64 40
  store double %.737.5, ptr %sunkaddr404, align 8
  %.818.5 = load double, ptr %scevgep206, align 8
  %sunkaddr405 = mul i64 %.652831833, 8
  %sunkaddr406 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr405
  %sunkaddr407 = getelementptr i8, ptr %sunkaddr406, i64 552
  store double %.818.5, ptr %sunkaddr407, align 8
  %20 = shl nuw nsw i64 %.652831833, 3
  %scevgep140 = getelementptr i8, ptr %scevgep136, i64 %20
  %scevgep141 = getelementptr i8, ptr %scevgep140, i64 -16
  %.900.5 = load double, ptr %scevgep141, align 8
  %sunkaddr408 = mul i64 %.652831833, 8
  %sunkaddr409 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr408
  %sunkaddr410 = getelementptr i8, ptr %sunkaddr409, i64 1064
  store double %.900.5, ptr %sunkaddr410, align 8
  %21 = shl nuw nsw i64 %.652831833, 3
  %scevgep203 = getelementptr i8, ptr %scevgep201, i64 %21
  %scevgep204 = getelementptr i8, ptr %scevgep203, i64 -8
  %.736.6 = load double, ptr %scevgep204, align 8
  %.737.6 = fmul double %.736.6, %.685
  %sunkaddr411 = mul i64 %.652831833, 8
  %sunkaddr412 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr411
  %sunkaddr413 = getelementptr i8, ptr %sunkaddr412, i64 48
  store double %.737.6, ptr %sunkaddr413, align 8
  %.818.6 = load double, ptr %scevgep204, align 8
  %sunkaddr414 = mul i64 %.652831833, 8
  %sunkaddr415 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr414
  %sunkaddr416 = getelementptr i8, ptr %sunkaddr415, i64 560
  store double %.818.6, ptr %sunkaddr416, align 8
  %22 = shl nuw nsw i64 %.652831833, 3
  %scevgep138 = getelementptr i8, ptr %scevgep136, i64 %22
  %scevgep139 = getelementptr i8, ptr %scevgep138, i64 -8
  %.900.6 = load double, ptr %scevgep139, align 8
  %sunkaddr417 = mul i64 %.652831833, 8
  %sunkaddr418 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr417
  %sunkaddr419 = getelementptr i8, ptr %sunkaddr418, i64 1072
  store double %.900.6, ptr %sunkaddr419, align 8
  %.659.7 = add nuw nsw i64 %.652831833, 8
  %23 = shl nuw nsw i64 %.652831833, 3
  %scevgep202 = getelementptr i8, ptr %scevgep201, i64 %23
  %.736.7 = load double, ptr %scevgep202, align 8
  %.737.7 = fmul double %.736.7, %.685
  %sunkaddr420 = mul i64 %.652831833, 8
  %sunkaddr421 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr420
  %sunkaddr422 = getelementptr i8, ptr %sunkaddr421, i64 56
  store double %.737.7, ptr %sunkaddr422, align 8
  %.818.7 = load double, ptr %scevgep202, align 8
  %sunkaddr423 = mul i64 %.652831833, 8
  %sunkaddr424 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr423
  %sunkaddr425 = getelementptr i8, ptr %sunkaddr424, i64 568
  store double %.818.7, ptr %sunkaddr425, align 8
  %24 = shl nuw nsw i64 %.652831833, 3
  %scevgep137 = getelementptr i8, ptr %scevgep136, i64 %24
  %.900.7 = load double, ptr %scevgep137, align 8
  %sunkaddr426 = mul i64 %.652831833, 8
  %sunkaddr427 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr426
  %sunkaddr428 = getelementptr i8, ptr %sunkaddr427, i64 1080
  store double %.900.7, ptr %sunkaddr428, align 8
  %exitcond925.not.7 = icmp eq i64 %.659.7, 64
  br i1 %exitcond925.not.7, label %B352, label %B224, !llvm.loop !310

B352:                                             ; preds = %B224, %vector.body75
  %.966 = call i32 @_ZN18elastomer_friction7kernels8rheology6scaled19_settle_and_predictB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE(ptr nonnull %.948, ptr nonnull %excinfo.1, ptr %arg.scales.5.0, ptr %arg.scales.5.1, i64 %arg.scales.5.2, i64 %arg.scales.5.3, ptr %arg.scales.5.4, i64 %arg.scales.5.5.0, i64 %arg.scales.5.6.0, ptr %arg.scales.3.0, ptr %arg.scales.3.1, i64 %arg.scales.3.2, i64 %arg.scales.3.3, ptr %arg.scales.3.4, i64 %arg.scales.3.5.0, i64 %arg.scales.3.6.0, ptr %arg.scales.4.0, ptr %arg.scales.4.1, i64 %arg.scales.4.2, i64 %arg.scales.4.3, ptr %arg.scales.4.4, i64 %arg.scales.4.5.0, i64 %arg.scales.4.6.0, ptr %arg.memory.0, ptr %arg.memory.1, i64 %arg.memory.2, i64 %arg.memory.3, ptr %arg.memory.4, i64 %arg.memory.5.0, i64 %arg.memory.5.1, i64 %arg.memory.5.2, i64 %arg.memory.6.0, i64 %arg.memory.6.1, i64 %arg.memory.6.2, i64 %.530, ptr %arg.total.0, ptr %arg.total.1, i64 %arg.total.2, i64 %arg.total.3, ptr nonnull %arg.total.4, i64 %arg.total.5.0, i64 %arg.total.6.0)
  switch i32 %.966, label %common.ret [
    i32 -2, label %B526.else
    i32 0, label %B526.else
  ], !prof !1

B480:                                             ; preds = %B140
  %25 = icmp slt i64 %arg.scales.5.2, 1
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(512) %arg.total.4, i8 0, i64 512, i1 false)
  br i1 %25, label %B526.else, label %B46.endif.endif.lr.ph.i

B46.endif.endif.lr.ph.i:                          ; preds = %B480
  %26 = and i64 %arg.memory.5.2, 1152921504606846976
  %27 = icmp ne i64 %26, 0
  %28 = icmp slt i64 %.530, 0
  %.390.i = select i1 %28, i64 %arg.memory.5.0, i64 0
  %.391.i = add i64 %.390.i, %.530
  %.421.i = mul i64 %.419.i, %.391.i
  %29 = getelementptr double, ptr %arg.memory.4, i64 %.421.i
  %30 = mul i64 %.391.i, %arg.memory.5.1
  %31 = add i64 %30, %arg.scales.5.2
  %32 = shl i64 %31, 3
  %33 = add i64 %32, -8
  %34 = mul i64 %33, %arg.memory.5.2
  %35 = getelementptr i8, ptr %arg.memory.4, i64 %34
  %scevgep1.i = getelementptr i8, ptr %35, i64 512
  %bound0.i = icmp ult ptr %arg.total.4, %scevgep1.i
  %bound1.i = icmp ult ptr %29, %scevgep.i
  %found.conflict.i = and i1 %bound1.i, %bound0.i
  %36 = or i1 %27, %found.conflict.i
  br i1 %36, label %B46.endif.endif.us.i.preheader, label %B46.endif.endif.i.preheader

B46.endif.endif.us.i.preheader:                   ; preds = %B46.endif.endif.lr.ph.i
  %37 = mul i64 %120, %.391.i
  %scevgep101 = getelementptr i8, ptr %scevgep100, i64 %37
  br label %B46.endif.endif.us.i

B46.endif.endif.i.preheader:                      ; preds = %B46.endif.endif.lr.ph.i
  %38 = icmp eq i64 %arg.scales.5.2, 1
  br i1 %38, label %B46.endif.endif.i.epil.preheader, label %B46.endif.endif.i.preheader64

B46.endif.endif.i.preheader64:                    ; preds = %B46.endif.endif.i.preheader
  %39 = mul i64 %115, %.391.i
  %40 = add i64 %39, 8
  %41 = mul i64 %arg.memory.5.2, %40
  %42 = mul i64 %118, %.391.i
  br label %B46.endif.endif.i

B46.endif.endif.us.i:                             ; preds = %B46.endif.endif.us.i.preheader, %B44.loopexit.loopexit.us.i
  %lsr.iv102 = phi ptr [ %scevgep101, %B46.endif.endif.us.i.preheader ], [ %scevgep103, %B44.loopexit.loopexit.us.i ]
  %.142185190.us.i = phi i64 [ %.149.us.i, %B44.loopexit.loopexit.us.i ], [ 0, %B46.endif.endif.us.i.preheader ]
  %43 = getelementptr double, ptr %arg.scales.5.4, i64 %.142185190.us.i
  %.207.us.i = load double, ptr %43, align 8, !noalias !311
  br label %B106.us.i

B106.us.i:                                        ; preds = %B106.us.i, %B46.endif.endif.us.i
  %.296180182.us.i = phi i64 [ %.303.7.us.i, %B106.us.i ], [ 0, %B46.endif.endif.us.i ]
  %sunkaddr429 = mul i64 %.296180182.us.i, 8
  %sunkaddr430 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr429
  %.357.us.i = load double, ptr %sunkaddr430, align 8, !noalias !311
  %44 = shl nuw nsw i64 %.296180182.us.i, 3
  %scevgep115 = getelementptr i8, ptr %lsr.iv102, i64 %44
  %scevgep116 = getelementptr i8, ptr %scevgep115, i64 -56
  %.428.us.i = load double, ptr %scevgep116, align 8, !noalias !311
  %.430.us.i = fmul double %.207.us.i, %.428.us.i
  %.431.us.i = fadd double %.357.us.i, %.430.us.i
  store double %.431.us.i, ptr %sunkaddr430, align 8, !noalias !311
  %sunkaddr431 = mul i64 %.296180182.us.i, 8
  %sunkaddr432 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr431
  %sunkaddr433 = getelementptr i8, ptr %sunkaddr432, i64 8
  %.357.1.us.i = load double, ptr %sunkaddr433, align 8, !noalias !311
  %45 = shl nuw nsw i64 %.296180182.us.i, 3
  %scevgep117 = getelementptr i8, ptr %lsr.iv102, i64 %45
  %scevgep118 = getelementptr i8, ptr %scevgep117, i64 -48
  %.428.1.us.i = load double, ptr %scevgep118, align 8, !noalias !311
  %.430.1.us.i = fmul double %.207.us.i, %.428.1.us.i
  %.431.1.us.i = fadd double %.357.1.us.i, %.430.1.us.i
  store double %.431.1.us.i, ptr %sunkaddr433, align 8, !noalias !311
  %sunkaddr434 = mul i64 %.296180182.us.i, 8
  %sunkaddr435 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr434
  %sunkaddr436 = getelementptr i8, ptr %sunkaddr435, i64 16
  %.357.2.us.i = load double, ptr %sunkaddr436, align 8, !noalias !311
  %46 = shl nuw nsw i64 %.296180182.us.i, 3
  %scevgep113 = getelementptr i8, ptr %lsr.iv102, i64 %46
  %scevgep114 = getelementptr i8, ptr %scevgep113, i64 -40
  %.428.2.us.i = load double, ptr %scevgep114, align 8, !noalias !311
  %.430.2.us.i = fmul double %.207.us.i, %.428.2.us.i
  %.431.2.us.i = fadd double %.357.2.us.i, %.430.2.us.i
  store double %.431.2.us.i, ptr %sunkaddr436, align 8, !noalias !311
  %sunkaddr437 = mul i64 %.296180182.us.i, 8
  %sunkaddr438 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr437
  %sunkaddr439 = getelementptr i8, ptr %sunkaddr438, i64 24
  %.357.3.us.i = load double, ptr %sunkaddr439, align 8, !noalias !311
  %47 = shl nuw nsw i64 %.296180182.us.i, 3
  %scevgep111 = getelementptr i8, ptr %lsr.iv102, i64 %47
  %scevgep112 = getelementptr i8, ptr %scevgep111, i64 -32
  %.428.3.us.i = load double, ptr %scevgep112, align 8, !noalias !311
  %.430.3.us.i = fmul double %.207.us.i, %.428.3.us.i
  %.431.3.us.i = fadd double %.357.3.us.i, %.430.3.us.i
  store double %.431.3.us.i, ptr %sunkaddr439, align 8, !noalias !311
  %sunkaddr440 = mul i64 %.296180182.us.i, 8
  %sunkaddr441 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr440
  %sunkaddr442 = getelementptr i8, ptr %sunkaddr441, i64 32
  %.357.4.us.i = load double, ptr %sunkaddr442, align 8, !noalias !311
  %48 = shl nuw nsw i64 %.296180182.us.i, 3
  %scevgep109 = getelementptr i8, ptr %lsr.iv102, i64 %48
  %scevgep110 = getelementptr i8, ptr %scevgep109, i64 -24
  %.428.4.us.i = load double, ptr %scevgep110, align 8, !noalias !311
  %.430.4.us.i = fmul double %.207.us.i, %.428.4.us.i
  %.431.4.us.i = fadd double %.357.4.us.i, %.430.4.us.i
  store double %.431.4.us.i, ptr %sunkaddr442, align 8, !noalias !311
  %sunkaddr443 = mul i64 %.296180182.us.i, 8
  %sunkaddr444 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr443
  %sunkaddr445 = getelementptr i8, ptr %sunkaddr444, i64 40
  %.357.5.us.i = load double, ptr %sunkaddr445, align 8, !noalias !311
  %49 = shl nuw nsw i64 %.296180182.us.i, 3
  %scevgep107 = getelementptr i8, ptr %lsr.iv102, i64 %49
  %scevgep108 = getelementptr i8, ptr %scevgep107, i64 -16
  %.428.5.us.i = load double, ptr %scevgep108, align 8, !noalias !311
  %.430.5.us.i = fmul double %.207.us.i, %.428.5.us.i
  %.431.5.us.i = fadd double %.357.5.us.i, %.430.5.us.i
  store double %.431.5.us.i, ptr %sunkaddr445, align 8, !noalias !311
  %sunkaddr446 = mul i64 %.296180182.us.i, 8
  %sunkaddr447 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr446
  %sunkaddr448 = getelementptr i8, ptr %sunkaddr447, i64 48
  %.357.6.us.i = load double, ptr %sunkaddr448, align 8, !noalias !311
  %50 = shl nuw nsw i64 %.296180182.us.i, 3
  %scevgep105 = getelementptr i8, ptr %lsr.iv102, i64 %50
  %scevgep106 = getelementptr i8, ptr %scevgep105, i64 -8
  %.428.6.us.i = load double, ptr %scevgep106, align 8, !noalias !311
  %.430.6.us.i = fmul double %.207.us.i, %.428.6.us.i
  %.431.6.us.i = fadd double %.357.6.us.i, %.430.6.us.i
  store double %.431.6.us.i, ptr %sunkaddr448, align 8, !noalias !311
  %.303.7.us.i = add nuw nsw i64 %.296180182.us.i, 8
  %sunkaddr449 = mul i64 %.296180182.us.i, 8
  %sunkaddr450 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr449
  %sunkaddr451 = getelementptr i8, ptr %sunkaddr450, i64 56
  %.357.7.us.i = load double, ptr %sunkaddr451, align 8, !noalias !311
  %51 = shl nuw nsw i64 %.296180182.us.i, 3
  %scevgep104 = getelementptr i8, ptr %lsr.iv102, i64 %51
  %.428.7.us.i = load double, ptr %scevgep104, align 8, !noalias !311
  %.430.7.us.i = fmul double %.207.us.i, %.428.7.us.i
  %.431.7.us.i = fadd double %.357.7.us.i, %.430.7.us.i
  store double %.431.7.us.i, ptr %sunkaddr451, align 8, !noalias !311
  %exitcond.not.7.us.i = icmp eq i64 %.303.7.us.i, 64
  br i1 %exitcond.not.7.us.i, label %B44.loopexit.loopexit.us.i, label %B106.us.i, !llvm.loop !314

B44.loopexit.loopexit.us.i:                       ; preds = %B106.us.i
  %.149.us.i = add nuw nsw i64 %.142185190.us.i, 1
  %scevgep103 = getelementptr i8, ptr %lsr.iv102, i64 %121
  %exitcond195.not.us.i = icmp eq i64 %.149.us.i, %arg.scales.5.2
  br i1 %exitcond195.not.us.i, label %B526.else, label %B46.endif.endif.us.i

B46.endif.endif.i:                                ; preds = %B46.endif.endif.i.preheader64, %B46.endif.endif.i
  %lsr.iv = phi ptr [ %scevgep68, %B46.endif.endif.i.preheader64 ], [ %scevgep69, %B46.endif.endif.i ]
  %52 = phi <8 x double> [ %91, %B46.endif.endif.i ], [ zeroinitializer, %B46.endif.endif.i.preheader64 ]
  %53 = phi <8 x double> [ %90, %B46.endif.endif.i ], [ zeroinitializer, %B46.endif.endif.i.preheader64 ]
  %54 = phi <8 x double> [ %89, %B46.endif.endif.i ], [ zeroinitializer, %B46.endif.endif.i.preheader64 ]
  %55 = phi <8 x double> [ %88, %B46.endif.endif.i ], [ zeroinitializer, %B46.endif.endif.i.preheader64 ]
  %56 = phi <8 x double> [ %83, %B46.endif.endif.i ], [ zeroinitializer, %B46.endif.endif.i.preheader64 ]
  %57 = phi <8 x double> [ %82, %B46.endif.endif.i ], [ zeroinitializer, %B46.endif.endif.i.preheader64 ]
  %58 = phi <8 x double> [ %81, %B46.endif.endif.i ], [ zeroinitializer, %B46.endif.endif.i.preheader64 ]
  %59 = phi <8 x double> [ %80, %B46.endif.endif.i ], [ zeroinitializer, %B46.endif.endif.i.preheader64 ]
  %.142185190.i = phi i64 [ %.149.i.1, %B46.endif.endif.i ], [ 0, %B46.endif.endif.i.preheader64 ]
  %sunkaddr452 = mul i64 %.142185190.i, 8
  %sunkaddr453 = getelementptr i8, ptr %arg.scales.5.4, i64 %sunkaddr452
  %.207.i = load double, ptr %sunkaddr453, align 8, !noalias !311
  %scevgep94 = getelementptr i8, ptr %lsr.iv, i64 %42
  %scevgep95 = getelementptr i8, ptr %scevgep94, i64 -448
  %broadcast.splatinsert.i = insertelement <8 x double> poison, double %.207.i, i64 0
  %broadcast.splat.i = shufflevector <8 x double> %broadcast.splatinsert.i, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep99 = getelementptr i8, ptr %scevgep94, i64 -384
  %scevgep98 = getelementptr i8, ptr %scevgep94, i64 -320
  %scevgep96 = getelementptr i8, ptr %lsr.iv, i64 %42
  %scevgep97 = getelementptr i8, ptr %scevgep96, i64 -256
  %wide.load5.i = load <8 x double>, ptr %scevgep95, align 8, !alias.scope !315, !noalias !311
  %wide.load6.i = load <8 x double>, ptr %scevgep99, align 8, !alias.scope !315, !noalias !311
  %wide.load7.i = load <8 x double>, ptr %scevgep98, align 8, !alias.scope !315, !noalias !311
  %wide.load8.i = load <8 x double>, ptr %scevgep97, align 8, !alias.scope !315, !noalias !311
  %60 = fmul <8 x double> %wide.load5.i, %broadcast.splat.i
  %61 = fmul <8 x double> %broadcast.splat.i, %wide.load6.i
  %62 = fmul <8 x double> %broadcast.splat.i, %wide.load7.i
  %63 = fmul <8 x double> %broadcast.splat.i, %wide.load8.i
  %64 = fadd <8 x double> %59, %60
  %65 = fadd <8 x double> %58, %61
  %66 = fadd <8 x double> %57, %62
  %67 = fadd <8 x double> %56, %63
  store <8 x double> %64, ptr %arg.total.4, align 8, !alias.scope !318, !noalias !320
  %sunkaddr454 = getelementptr i8, ptr %arg.total.4, i64 64
  store <8 x double> %65, ptr %sunkaddr454, align 8, !alias.scope !318, !noalias !320
  %sunkaddr455 = getelementptr i8, ptr %arg.total.4, i64 128
  store <8 x double> %66, ptr %sunkaddr455, align 8, !alias.scope !318, !noalias !320
  %sunkaddr456 = getelementptr i8, ptr %arg.total.4, i64 192
  store <8 x double> %67, ptr %sunkaddr456, align 8, !alias.scope !318, !noalias !320
  %scevgep92 = getelementptr i8, ptr %lsr.iv, i64 %42
  %scevgep93 = getelementptr i8, ptr %scevgep92, i64 -192
  %scevgep90 = getelementptr i8, ptr %lsr.iv, i64 %42
  %scevgep91 = getelementptr i8, ptr %scevgep90, i64 -128
  %scevgep88 = getelementptr i8, ptr %lsr.iv, i64 %42
  %scevgep89 = getelementptr i8, ptr %scevgep88, i64 -64
  %scevgep87 = getelementptr i8, ptr %lsr.iv, i64 %42
  %wide.load5.1.i = load <8 x double>, ptr %scevgep93, align 8, !alias.scope !315, !noalias !311
  %wide.load6.1.i = load <8 x double>, ptr %scevgep91, align 8, !alias.scope !315, !noalias !311
  %wide.load7.1.i = load <8 x double>, ptr %scevgep89, align 8, !alias.scope !315, !noalias !311
  %wide.load8.1.i = load <8 x double>, ptr %scevgep87, align 8, !alias.scope !315, !noalias !311
  %68 = fmul <8 x double> %broadcast.splat.i, %wide.load5.1.i
  %69 = fmul <8 x double> %broadcast.splat.i, %wide.load6.1.i
  %70 = fmul <8 x double> %broadcast.splat.i, %wide.load7.1.i
  %71 = fmul <8 x double> %broadcast.splat.i, %wide.load8.1.i
  %72 = fadd <8 x double> %55, %68
  %73 = fadd <8 x double> %54, %69
  %74 = fadd <8 x double> %53, %70
  %75 = fadd <8 x double> %52, %71
  %sunkaddr457 = getelementptr i8, ptr %arg.total.4, i64 256
  store <8 x double> %72, ptr %sunkaddr457, align 8, !alias.scope !318, !noalias !320
  %sunkaddr458 = getelementptr i8, ptr %arg.total.4, i64 320
  store <8 x double> %73, ptr %sunkaddr458, align 8, !alias.scope !318, !noalias !320
  %sunkaddr459 = getelementptr i8, ptr %arg.total.4, i64 384
  store <8 x double> %74, ptr %sunkaddr459, align 8, !alias.scope !318, !noalias !320
  %sunkaddr460 = getelementptr i8, ptr %arg.total.4, i64 448
  store <8 x double> %75, ptr %sunkaddr460, align 8, !alias.scope !318, !noalias !320
  %sunkaddr461 = mul i64 %.142185190.i, 8
  %sunkaddr462 = getelementptr i8, ptr %arg.scales.5.4, i64 %sunkaddr461
  %sunkaddr463 = getelementptr i8, ptr %sunkaddr462, i64 8
  %.207.i.1 = load double, ptr %sunkaddr463, align 8, !noalias !311
  %scevgep77 = getelementptr i8, ptr %lsr.iv, i64 %41
  %scevgep78 = getelementptr i8, ptr %scevgep77, i64 -448
  %broadcast.splatinsert.i.1 = insertelement <8 x double> poison, double %.207.i.1, i64 0
  %broadcast.splat.i.1 = shufflevector <8 x double> %broadcast.splatinsert.i.1, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep82 = getelementptr i8, ptr %scevgep77, i64 -384
  %scevgep81 = getelementptr i8, ptr %scevgep77, i64 -320
  %scevgep79 = getelementptr i8, ptr %lsr.iv, i64 %41
  %scevgep80 = getelementptr i8, ptr %scevgep79, i64 -256
  %wide.load5.i.1 = load <8 x double>, ptr %scevgep78, align 8, !alias.scope !315, !noalias !311
  %wide.load6.i.1 = load <8 x double>, ptr %scevgep82, align 8, !alias.scope !315, !noalias !311
  %wide.load7.i.1 = load <8 x double>, ptr %scevgep81, align 8, !alias.scope !315, !noalias !311
  %wide.load8.i.1 = load <8 x double>, ptr %scevgep80, align 8, !alias.scope !315, !noalias !311
  %76 = fmul <8 x double> %wide.load5.i.1, %broadcast.splat.i.1
  %77 = fmul <8 x double> %broadcast.splat.i.1, %wide.load6.i.1
  %78 = fmul <8 x double> %broadcast.splat.i.1, %wide.load7.i.1
  %79 = fmul <8 x double> %broadcast.splat.i.1, %wide.load8.i.1
  %80 = fadd <8 x double> %64, %76
  %81 = fadd <8 x double> %65, %77
  %82 = fadd <8 x double> %66, %78
  %83 = fadd <8 x double> %67, %79
  store <8 x double> %80, ptr %arg.total.4, align 8, !alias.scope !318, !noalias !320
  store <8 x double> %81, ptr %sunkaddr454, align 8, !alias.scope !318, !noalias !320
  store <8 x double> %82, ptr %sunkaddr455, align 8, !alias.scope !318, !noalias !320
  store <8 x double> %83, ptr %sunkaddr456, align 8, !alias.scope !318, !noalias !320
  %scevgep75 = getelementptr i8, ptr %lsr.iv, i64 %41
  %scevgep76 = getelementptr i8, ptr %scevgep75, i64 -192
  %scevgep73 = getelementptr i8, ptr %lsr.iv, i64 %41
  %scevgep74 = getelementptr i8, ptr %scevgep73, i64 -128
  %scevgep71 = getelementptr i8, ptr %lsr.iv, i64 %41
  %scevgep72 = getelementptr i8, ptr %scevgep71, i64 -64
  %scevgep70 = getelementptr i8, ptr %lsr.iv, i64 %41
  %wide.load5.1.i.1 = load <8 x double>, ptr %scevgep76, align 8, !alias.scope !315, !noalias !311
  %wide.load6.1.i.1 = load <8 x double>, ptr %scevgep74, align 8, !alias.scope !315, !noalias !311
  %wide.load7.1.i.1 = load <8 x double>, ptr %scevgep72, align 8, !alias.scope !315, !noalias !311
  %wide.load8.1.i.1 = load <8 x double>, ptr %scevgep70, align 8, !alias.scope !315, !noalias !311
  %84 = fmul <8 x double> %broadcast.splat.i.1, %wide.load5.1.i.1
  %85 = fmul <8 x double> %broadcast.splat.i.1, %wide.load6.1.i.1
  %86 = fmul <8 x double> %broadcast.splat.i.1, %wide.load7.1.i.1
  %87 = fmul <8 x double> %broadcast.splat.i.1, %wide.load8.1.i.1
  %88 = fadd <8 x double> %72, %84
  %89 = fadd <8 x double> %73, %85
  %90 = fadd <8 x double> %74, %86
  %91 = fadd <8 x double> %75, %87
  store <8 x double> %88, ptr %sunkaddr457, align 8, !alias.scope !318, !noalias !320
  store <8 x double> %89, ptr %sunkaddr458, align 8, !alias.scope !318, !noalias !320
  store <8 x double> %90, ptr %sunkaddr459, align 8, !alias.scope !318, !noalias !320
  store <8 x double> %91, ptr %sunkaddr460, align 8, !alias.scope !318, !noalias !320
  %.149.i.1 = add nuw i64 %.142185190.i, 2
  %scevgep69 = getelementptr i8, ptr %lsr.iv, i64 %116
  %niter108.ncmp.1 = icmp eq i64 %unroll_iter107, %.149.i.1
  br i1 %niter108.ncmp.1, label %B526.else.loopexit86.unr-lcssa, label %B46.endif.endif.i

B626:                                             ; preds = %B626.preheader63, %B626
  %.1450838840 = phi i64 [ %.1457.7, %B626 ], [ %.1450838840.unr, %B626.preheader63 ]
  %92 = shl i64 %.1450838840, 3
  %scevgep288 = getelementptr i8, ptr %scevgep276, i64 %92
  %scevgep289 = getelementptr i8, ptr %scevgep288, i64 -56
  %.1511 = load double, ptr %scevgep289, align 8
  %sunkaddr464 = mul i64 %.1450838840, 8
  %sunkaddr465 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr464
  %.1541 = load double, ptr %sunkaddr465, align 8
  %.1542 = fsub double %.1511, %.1541
  %93 = shl i64 %.1450838840, 3
  %scevgep246 = getelementptr i8, ptr %lsr.iv235, i64 %93
  store double %.1542, ptr %scevgep246, align 8
  %scevgep290 = getelementptr i8, ptr %scevgep276, i64 %93
  %scevgep291 = getelementptr i8, ptr %scevgep290, i64 -48
  %.1511.1 = load double, ptr %scevgep291, align 8
  %sunkaddr466 = mul i64 %.1450838840, 8
  %sunkaddr467 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr466
  %sunkaddr468 = getelementptr i8, ptr %sunkaddr467, i64 8
  %.1541.1 = load double, ptr %sunkaddr468, align 8
  %.1542.1 = fsub double %.1511.1, %.1541.1
  %94 = shl i64 %.1450838840, 3
  %scevgep249 = getelementptr i8, ptr %lsr.iv235, i64 %94
  %scevgep250 = getelementptr i8, ptr %scevgep249, i64 8
  store double %.1542.1, ptr %scevgep250, align 8
  %scevgep286 = getelementptr i8, ptr %scevgep276, i64 %94
  %scevgep287 = getelementptr i8, ptr %scevgep286, i64 -40
  %.1511.2 = load double, ptr %scevgep287, align 8
  %sunkaddr469 = mul i64 %.1450838840, 8
  %sunkaddr470 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr469
  %sunkaddr471 = getelementptr i8, ptr %sunkaddr470, i64 16
  %.1541.2 = load double, ptr %sunkaddr471, align 8
  %.1542.2 = fsub double %.1511.2, %.1541.2
  %95 = shl i64 %.1450838840, 3
  %scevgep251 = getelementptr i8, ptr %lsr.iv235, i64 %95
  %scevgep252 = getelementptr i8, ptr %scevgep251, i64 16
  store double %.1542.2, ptr %scevgep252, align 8
  %scevgep284 = getelementptr i8, ptr %scevgep276, i64 %95
  %scevgep285 = getelementptr i8, ptr %scevgep284, i64 -32
  %.1511.3 = load double, ptr %scevgep285, align 8
  %sunkaddr472 = mul i64 %.1450838840, 8
  %sunkaddr473 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr472
  %sunkaddr474 = getelementptr i8, ptr %sunkaddr473, i64 24
  %.1541.3 = load double, ptr %sunkaddr474, align 8
  %.1542.3 = fsub double %.1511.3, %.1541.3
  %96 = shl i64 %.1450838840, 3
  %scevgep253 = getelementptr i8, ptr %lsr.iv235, i64 %96
  %scevgep254 = getelementptr i8, ptr %scevgep253, i64 24
  store double %.1542.3, ptr %scevgep254, align 8
  %scevgep282 = getelementptr i8, ptr %scevgep276, i64 %96
  %scevgep283 = getelementptr i8, ptr %scevgep282, i64 -24
  %.1511.4 = load double, ptr %scevgep283, align 8
  %sunkaddr475 = mul i64 %.1450838840, 8
  %sunkaddr476 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr475
  %sunkaddr477 = getelementptr i8, ptr %sunkaddr476, i64 32
  %.1541.4 = load double, ptr %sunkaddr477, align 8
  %.1542.4 = fsub double %.1511.4, %.1541.4
  %97 = shl i64 %.1450838840, 3
  %scevgep244 = getelementptr i8, ptr %lsr.iv235, i64 %97
  %scevgep245 = getelementptr i8, ptr %scevgep244, i64 32
  store double %.1542.4, ptr %scevgep245, align 8
  %scevgep280 = getelementptr i8, ptr %scevgep276, i64 %97
  %scevgep281 = getelementptr i8, ptr %scevgep280, i64 -16
  %.1511.5 = load double, ptr %scevgep281, align 8
  %sunkaddr478 = mul i64 %.1450838840, 8
  %sunkaddr479 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr478
  %sunkaddr480 = getelementptr i8, ptr %sunkaddr479, i64 40
  %.1541.5 = load double, ptr %sunkaddr480, align 8
  %.1542.5 = fsub double %.1511.5, %.1541.5
  %98 = shl i64 %.1450838840, 3
  %scevgep257 = getelementptr i8, ptr %lsr.iv235, i64 %98
  %scevgep258 = getelementptr i8, ptr %scevgep257, i64 40
  store double %.1542.5, ptr %scevgep258, align 8
  %scevgep278 = getelementptr i8, ptr %scevgep276, i64 %98
  %scevgep279 = getelementptr i8, ptr %scevgep278, i64 -8
  %.1511.6 = load double, ptr %scevgep279, align 8
  %sunkaddr481 = mul i64 %.1450838840, 8
  %sunkaddr482 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr481
  %sunkaddr483 = getelementptr i8, ptr %sunkaddr482, i64 48
  %.1541.6 = load double, ptr %sunkaddr483, align 8
  %.1542.6 = fsub double %.1511.6, %.1541.6
  %99 = shl i64 %.1450838840, 3
  %scevgep255 = getelementptr i8, ptr %lsr.iv235, i64 %99
  %scevgep256 = getelementptr i8, ptr %scevgep255, i64 48
  store double %.1542.6, ptr %scevgep256, align 8
  %.1457.7 = add nuw nsw i64 %.1450838840, 8
  %scevgep277 = getelementptr i8, ptr %scevgep276, i64 %99
  %.1511.7 = load double, ptr %scevgep277, align 8
  %sunkaddr484 = mul i64 %.1450838840, 8
  %sunkaddr485 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr484
  %sunkaddr486 = getelementptr i8, ptr %sunkaddr485, i64 56
  %.1541.7 = load double, ptr %sunkaddr486, align 8
  %.1542.7 = fsub double %.1511.7, %.1541.7
  %100 = shl i64 %.1450838840, 3
  %scevgep247 = getelementptr i8, ptr %lsr.iv235, i64 %100
  %scevgep248 = getelementptr i8, ptr %scevgep247, i64 56
  store double %.1542.7, ptr %scevgep248, align 8
  %exitcond926.not.7 = icmp eq i64 %.1301, %.1457.7
  br i1 %exitcond926.not.7, label %B674.endif, label %B626, !llvm.loop !321

B728:                                             ; preds = %B728.preheader, %B728
  %lsr.iv296 = phi i64 [ %210, %B728.preheader ], [ %lsr.iv.next297, %B728 ]
  %.1693845847 = phi i64 [ %.1700, %B728 ], [ %.1693845847.ph, %B728.preheader ]
  %.1700 = add nuw i64 %.1693845847, 1
  %.1751 = icmp slt i64 %.1693845847, 0
  %.1752 = select i1 %.1751, i64 %arg.c.5.1, i64 0
  %101 = shl i64 %.1752, 3
  %scevgep298 = getelementptr i8, ptr %lsr.iv235, i64 %101
  %102 = shl i64 %.1693845847, 3
  %scevgep299 = getelementptr i8, ptr %scevgep298, i64 %102
  store double 0x7FF0000000000000, ptr %scevgep299, align 8
  %lsr.iv.next297 = add i64 %lsr.iv296, -1
  %.1687 = icmp sgt i64 %lsr.iv.next297, 1
  br i1 %.1687, label %B728, label %B138.loopexit, !llvm.loop !322

common.ret:                                       ; preds = %B352, %B138.loopexit, %B96.endif
  %excinfo.sink = phi ptr [ %retptr, %B96.endif ], [ %retptr, %B138.loopexit ], [ %excinfo, %B352 ]
  %common.ret.op = phi i32 [ 0, %B96.endif ], [ 0, %B138.loopexit ], [ %.966, %B352 ]
  store ptr null, ptr %excinfo.sink, align 8
  ret i32 %common.ret.op

B96.endif.loopexit.unr-lcssa.unr-lcssa:           ; preds = %B60
  %103 = and i64 %arg.law.2.2, %const
  %lcmp.mod.not66 = icmp eq i64 %xtraiter48, 0
  br i1 %lcmp.mod.not66, label %B96.endif.loopexit.unr-lcssa, label %B60.epil.preheader47

B60.epil.preheader47:                             ; preds = %B96.endif.loopexit.unr-lcssa.unr-lcssa, %B60.preheader.new
  %now.2.0820.epil.init55 = phi double [ 0.000000e+00, %B60.preheader.new ], [ %.362.7.3, %B96.endif.loopexit.unr-lcssa.unr-lcssa ]
  %.298816818.epil.init56 = phi i64 [ 0, %B60.preheader.new ], [ %103, %B96.endif.loopexit.unr-lcssa.unr-lcssa ]
  %104 = shl i64 %.298816818.epil.init56, 3
  %105 = add nuw nsw i64 %104, 56
  %scevgep302 = getelementptr i8, ptr %arg.law.2.4, i64 %105
  %106 = shl nuw nsw i64 %xtraiter48, 6
  br label %B60.epil49

B60.epil49:                                       ; preds = %B60.epil49, %B60.epil.preheader47
  %lsr.iv303 = phi i64 [ %lsr.iv.next304, %B60.epil49 ], [ 0, %B60.epil.preheader47 ]
  %now.2.0820.epil50 = phi double [ %now.2.0820.epil.init55, %B60.epil.preheader47 ], [ %.362.7.epil, %B60.epil49 ]
  %scevgep318 = getelementptr i8, ptr %scevgep302, i64 %lsr.iv303
  %scevgep319 = getelementptr i8, ptr %scevgep318, i64 -56
  %.360.epil52 = load double, ptr %scevgep319, align 8
  %.362.epil53 = fadd double %now.2.0820.epil50, %.360.epil52
  %scevgep316 = getelementptr i8, ptr %scevgep302, i64 %lsr.iv303
  %scevgep317 = getelementptr i8, ptr %scevgep316, i64 -48
  %.360.1.epil = load double, ptr %scevgep317, align 8
  %.362.1.epil = fadd double %.362.epil53, %.360.1.epil
  %scevgep314 = getelementptr i8, ptr %scevgep302, i64 %lsr.iv303
  %scevgep315 = getelementptr i8, ptr %scevgep314, i64 -40
  %.360.2.epil = load double, ptr %scevgep315, align 8
  %.362.2.epil = fadd double %.362.1.epil, %.360.2.epil
  %scevgep312 = getelementptr i8, ptr %scevgep302, i64 %lsr.iv303
  %scevgep313 = getelementptr i8, ptr %scevgep312, i64 -32
  %.360.3.epil = load double, ptr %scevgep313, align 8
  %.362.3.epil = fadd double %.362.2.epil, %.360.3.epil
  %scevgep310 = getelementptr i8, ptr %scevgep302, i64 %lsr.iv303
  %scevgep311 = getelementptr i8, ptr %scevgep310, i64 -24
  %.360.4.epil = load double, ptr %scevgep311, align 8
  %.362.4.epil = fadd double %.362.3.epil, %.360.4.epil
  %scevgep308 = getelementptr i8, ptr %scevgep302, i64 %lsr.iv303
  %scevgep309 = getelementptr i8, ptr %scevgep308, i64 -16
  %.360.5.epil = load double, ptr %scevgep309, align 8
  %.362.5.epil = fadd double %.362.4.epil, %.360.5.epil
  %scevgep306 = getelementptr i8, ptr %scevgep302, i64 %lsr.iv303
  %scevgep307 = getelementptr i8, ptr %scevgep306, i64 -8
  %.360.6.epil = load double, ptr %scevgep307, align 8
  %.362.6.epil = fadd double %.362.5.epil, %.360.6.epil
  %scevgep305 = getelementptr i8, ptr %scevgep302, i64 %lsr.iv303
  %.360.7.epil = load double, ptr %scevgep305, align 8
  %.362.7.epil = fadd double %.362.6.epil, %.360.7.epil
  %lsr.iv.next304 = add nuw nsw i64 %lsr.iv303, 64
  %epil.iter54.cmp.not = icmp eq i64 %106, %lsr.iv.next304
  br i1 %epil.iter54.cmp.not, label %B96.endif.loopexit.unr-lcssa, label %B60.epil49, !llvm.loop !323

B96.endif.loopexit.unr-lcssa:                     ; preds = %B60.epil49, %B96.endif.loopexit.unr-lcssa.unr-lcssa
  %.362.7.lcssa = phi double [ %.362.7.3, %B96.endif.loopexit.unr-lcssa.unr-lcssa ], [ %.362.7.epil, %B60.epil49 ]
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B96.endif, label %B60.epil.preheader

B60.epil.preheader:                               ; preds = %B96.endif.loopexit.unr-lcssa, %B60.preheader
  %now.2.0820.epil.init = phi double [ 0.000000e+00, %B60.preheader ], [ %.362.7.lcssa, %B96.endif.loopexit.unr-lcssa ]
  %.298816818.epil.init = phi i64 [ 0, %B60.preheader ], [ %unroll_iter, %B96.endif.loopexit.unr-lcssa ]
  %107 = shl i64 %.298816818.epil.init, 3
  %scevgep300 = getelementptr i8, ptr %arg.law.2.4, i64 %107
  br label %B60.epil

B60.epil:                                         ; preds = %B60.epil, %B60.epil.preheader
  %now.2.0820.epil = phi double [ %.362.epil, %B60.epil ], [ %now.2.0820.epil.init, %B60.epil.preheader ]
  %epil.iter = phi i64 [ %epil.iter.next, %B60.epil ], [ 0, %B60.epil.preheader ]
  %108 = shl nuw nsw i64 %epil.iter, 3
  %scevgep301 = getelementptr i8, ptr %scevgep300, i64 %108
  %.360.epil = load double, ptr %scevgep301, align 8
  %.362.epil = fadd double %now.2.0820.epil, %.360.epil
  %epil.iter.next = add nuw nsw i64 %epil.iter, 1
  %epil.iter.cmp.not = icmp eq i64 %xtraiter, %epil.iter.next
  br i1 %epil.iter.cmp.not, label %B96.endif, label %B60.epil, !llvm.loop !324

B96.endif:                                        ; preds = %B60.epil, %B96.endif.loopexit.unr-lcssa, %B0.endif
  %now.2.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %.362.7.lcssa, %B96.endif.loopexit.unr-lcssa ], [ %.362.epil, %B60.epil ]
  %.459887.not = icmp slt i64 %arg.some.2, 1
  br i1 %.459887.not, label %common.ret, label %B140.lr.ph

B140.lr.ph:                                       ; preds = %B96.endif
  %109 = ptrtoint ptr %arg.c.4 to i64
  %110 = ptrtoint ptr %arg.total.4 to i64
  %const356 = bitcast i64 9223372036854775776 to i64
  %.685 = fneg double %now.2.0.lcssa
  %.419.i = mul i64 %arg.memory.5.2, %arg.memory.5.1
  %scevgep.i = getelementptr i8, ptr %arg.total.4, i64 512
  %111 = shl i64 %arg.c.5.1, 3
  %112 = sub i64 %109, %110
  %scevgep = getelementptr i8, ptr %arg.total.4, i64 1536
  %scevgep64 = getelementptr i8, ptr %arg.p.4, i64 512
  %113 = shl i64 %arg.p.5.1, 3
  %scevgep66 = getelementptr i8, ptr %arg.older.4, i64 512
  %114 = shl i64 %arg.older.5.1, 3
  %const_mat358 = add i64 %const356, 30
  %unroll_iter107 = and i64 %arg.scales.5.2, %const_mat358
  %broadcast.splatinsert73 = insertelement <8 x double> poison, double %.685, i64 0
  %broadcast.splat74 = shufflevector <8 x double> %broadcast.splatinsert73, <8 x double> poison, <8 x i32> zeroinitializer
  %broadcast.splatinsert = insertelement <8 x i64> poison, i64 %arg.c.5.1, i64 0
  %broadcast.splat = shufflevector <8 x i64> %broadcast.splatinsert, <8 x i64> poison, <8 x i32> zeroinitializer
  %.423.i.epil = mul i64 %arg.memory.5.2, %unroll_iter107
  %115 = shl i64 %arg.memory.5.1, 3
  %scevgep68 = getelementptr i8, ptr %arg.memory.4, i64 448
  %116 = shl i64 %arg.memory.5.2, 4
  %117 = mul i64 %arg.memory.5.2, %arg.memory.5.1
  %118 = shl i64 %117, 3
  %scevgep100 = getelementptr i8, ptr %arg.memory.4, i64 56
  %119 = mul i64 %arg.memory.5.2, %arg.memory.5.1
  %120 = shl i64 %119, 3
  %121 = shl i64 %arg.memory.5.2, 3
  %scevgep135 = getelementptr i8, ptr %arg.older.4, i64 56
  %122 = shl i64 %arg.older.5.1, 3
  %scevgep200 = getelementptr i8, ptr %arg.p.4, i64 56
  %123 = shl i64 %arg.p.5.1, 3
  %scevgep217 = getelementptr i8, ptr %arg.c.4, i64 192
  %scevgep229 = getelementptr i8, ptr %arg.z.4, i64 192
  %scevgep275 = getelementptr i8, ptr %arg.z.4, i64 56
  br label %B140

B224.lr.ph:                                       ; preds = %B140
  %124 = icmp slt i64 %.530, 0
  %.710 = select i1 %124, i64 %arg.p.5.0, i64 0
  %.711 = add i64 %.710, %.530
  %.731 = mul i64 %.711, %arg.p.5.1
  %125 = getelementptr double, ptr %arg.p.4, i64 %.731
  %.874 = select i1 %124, i64 %arg.older.5.0, i64 0
  %.875 = add i64 %.874, %.530
  %.895 = mul i64 %.875, %arg.older.5.1
  %126 = getelementptr double, ptr %arg.older.4, i64 %.895
  %127 = mul i64 %113, %.711
  %scevgep65 = getelementptr i8, ptr %scevgep64, i64 %127
  %128 = mul i64 %114, %.875
  %scevgep67 = getelementptr i8, ptr %scevgep66, i64 %128
  %bound0 = icmp ult ptr %arg.total.4, %scevgep65
  %bound1 = icmp ult ptr %125, %scevgep
  %found.conflict = and i1 %bound0, %bound1
  %bound068 = icmp ult ptr %arg.total.4, %scevgep67
  %bound169 = icmp ult ptr %126, %scevgep
  %found.conflict70 = and i1 %bound068, %bound169
  %conflict.rdx71 = or i1 %found.conflict, %found.conflict70
  br i1 %conflict.rdx71, label %B224.preheader, label %vector.body75

B224.preheader:                                   ; preds = %B224.lr.ph
  %129 = mul i64 %122, %.875
  %scevgep136 = getelementptr i8, ptr %scevgep135, i64 %129
  %130 = mul i64 %123, %.711
  %scevgep201 = getelementptr i8, ptr %scevgep200, i64 %130
  br label %B224

vector.body75:                                    ; preds = %B224.lr.ph
  %131 = getelementptr i8, ptr %125, i64 64
  %wide.load77 = load <8 x double>, ptr %125, align 8, !alias.scope !325
  %wide.load78 = load <8 x double>, ptr %131, align 8, !alias.scope !325
  %132 = fmul <8 x double> %broadcast.splat74, %wide.load77
  %133 = fmul <8 x double> %broadcast.splat74, %wide.load78
  store <8 x double> %132, ptr %arg.total.4, align 8, !alias.scope !328, !noalias !330
  %sunkaddr487 = getelementptr i8, ptr %arg.total.4, i64 64
  store <8 x double> %133, ptr %sunkaddr487, align 8, !alias.scope !328, !noalias !330
  %sunkaddr488 = getelementptr i8, ptr %arg.total.4, i64 512
  store <8 x double> %wide.load77, ptr %sunkaddr488, align 8, !alias.scope !328, !noalias !330
  %sunkaddr489 = getelementptr i8, ptr %arg.total.4, i64 576
  store <8 x double> %wide.load78, ptr %sunkaddr489, align 8, !alias.scope !328, !noalias !330
  %134 = getelementptr i8, ptr %126, i64 64
  %wide.load81 = load <8 x double>, ptr %126, align 8, !alias.scope !332
  %wide.load82 = load <8 x double>, ptr %134, align 8, !alias.scope !332
  %sunkaddr490 = getelementptr i8, ptr %arg.total.4, i64 1024
  store <8 x double> %wide.load81, ptr %sunkaddr490, align 8, !alias.scope !328, !noalias !330
  %sunkaddr491 = getelementptr i8, ptr %arg.total.4, i64 1088
  store <8 x double> %wide.load82, ptr %sunkaddr491, align 8, !alias.scope !328, !noalias !330
  %135 = getelementptr i8, ptr %125, i64 128
  %136 = getelementptr i8, ptr %125, i64 192
  %wide.load77.1 = load <8 x double>, ptr %135, align 8, !alias.scope !325
  %wide.load78.1 = load <8 x double>, ptr %136, align 8, !alias.scope !325
  %137 = fmul <8 x double> %broadcast.splat74, %wide.load77.1
  %138 = fmul <8 x double> %broadcast.splat74, %wide.load78.1
  %sunkaddr492 = getelementptr i8, ptr %arg.total.4, i64 128
  store <8 x double> %137, ptr %sunkaddr492, align 8, !alias.scope !328, !noalias !330
  %sunkaddr493 = getelementptr i8, ptr %arg.total.4, i64 192
  store <8 x double> %138, ptr %sunkaddr493, align 8, !alias.scope !328, !noalias !330
  %sunkaddr494 = getelementptr i8, ptr %arg.total.4, i64 640
  store <8 x double> %wide.load77.1, ptr %sunkaddr494, align 8, !alias.scope !328, !noalias !330
  %sunkaddr495 = getelementptr i8, ptr %arg.total.4, i64 704
  store <8 x double> %wide.load78.1, ptr %sunkaddr495, align 8, !alias.scope !328, !noalias !330
  %139 = getelementptr i8, ptr %126, i64 128
  %140 = getelementptr i8, ptr %126, i64 192
  %wide.load81.1 = load <8 x double>, ptr %139, align 8, !alias.scope !332
  %wide.load82.1 = load <8 x double>, ptr %140, align 8, !alias.scope !332
  %sunkaddr496 = getelementptr i8, ptr %arg.total.4, i64 1152
  store <8 x double> %wide.load81.1, ptr %sunkaddr496, align 8, !alias.scope !328, !noalias !330
  %sunkaddr497 = getelementptr i8, ptr %arg.total.4, i64 1216
  store <8 x double> %wide.load82.1, ptr %sunkaddr497, align 8, !alias.scope !328, !noalias !330
  %141 = getelementptr i8, ptr %125, i64 256
  %142 = getelementptr i8, ptr %125, i64 320
  %wide.load77.2 = load <8 x double>, ptr %141, align 8, !alias.scope !325
  %wide.load78.2 = load <8 x double>, ptr %142, align 8, !alias.scope !325
  %143 = fmul <8 x double> %broadcast.splat74, %wide.load77.2
  %144 = fmul <8 x double> %broadcast.splat74, %wide.load78.2
  %sunkaddr498 = getelementptr i8, ptr %arg.total.4, i64 256
  store <8 x double> %143, ptr %sunkaddr498, align 8, !alias.scope !328, !noalias !330
  %sunkaddr499 = getelementptr i8, ptr %arg.total.4, i64 320
  store <8 x double> %144, ptr %sunkaddr499, align 8, !alias.scope !328, !noalias !330
  %sunkaddr500 = getelementptr i8, ptr %arg.total.4, i64 768
  store <8 x double> %wide.load77.2, ptr %sunkaddr500, align 8, !alias.scope !328, !noalias !330
  %sunkaddr501 = getelementptr i8, ptr %arg.total.4, i64 832
  store <8 x double> %wide.load78.2, ptr %sunkaddr501, align 8, !alias.scope !328, !noalias !330
  %145 = getelementptr i8, ptr %126, i64 256
  %146 = getelementptr i8, ptr %126, i64 320
  %wide.load81.2 = load <8 x double>, ptr %145, align 8, !alias.scope !332
  %wide.load82.2 = load <8 x double>, ptr %146, align 8, !alias.scope !332
  %sunkaddr502 = getelementptr i8, ptr %arg.total.4, i64 1280
  store <8 x double> %wide.load81.2, ptr %sunkaddr502, align 8, !alias.scope !328, !noalias !330
  %sunkaddr503 = getelementptr i8, ptr %arg.total.4, i64 1344
  store <8 x double> %wide.load82.2, ptr %sunkaddr503, align 8, !alias.scope !328, !noalias !330
  %147 = getelementptr i8, ptr %125, i64 384
  %148 = getelementptr i8, ptr %125, i64 448
  %wide.load77.3 = load <8 x double>, ptr %147, align 8, !alias.scope !325
  %wide.load78.3 = load <8 x double>, ptr %148, align 8, !alias.scope !325
  %149 = fmul <8 x double> %broadcast.splat74, %wide.load77.3
  %150 = fmul <8 x double> %broadcast.splat74, %wide.load78.3
  %sunkaddr504 = getelementptr i8, ptr %arg.total.4, i64 384
  store <8 x double> %149, ptr %sunkaddr504, align 8, !alias.scope !328, !noalias !330
  %sunkaddr505 = getelementptr i8, ptr %arg.total.4, i64 448
  store <8 x double> %150, ptr %sunkaddr505, align 8, !alias.scope !328, !noalias !330
  %sunkaddr506 = getelementptr i8, ptr %arg.total.4, i64 896
  store <8 x double> %wide.load77.3, ptr %sunkaddr506, align 8, !alias.scope !328, !noalias !330
  %sunkaddr507 = getelementptr i8, ptr %arg.total.4, i64 960
  store <8 x double> %wide.load78.3, ptr %sunkaddr507, align 8, !alias.scope !328, !noalias !330
  %151 = getelementptr i8, ptr %126, i64 384
  %152 = getelementptr i8, ptr %126, i64 448
  %wide.load81.3 = load <8 x double>, ptr %151, align 8, !alias.scope !332
  %wide.load82.3 = load <8 x double>, ptr %152, align 8, !alias.scope !332
  %sunkaddr508 = getelementptr i8, ptr %arg.total.4, i64 1408
  store <8 x double> %wide.load81.3, ptr %sunkaddr508, align 8, !alias.scope !328, !noalias !330
  %sunkaddr509 = getelementptr i8, ptr %arg.total.4, i64 1472
  store <8 x double> %wide.load82.3, ptr %sunkaddr509, align 8, !alias.scope !328, !noalias !330
  br label %B352

B526.else.loopexit86.unr-lcssa:                   ; preds = %B46.endif.endif.i
  %153 = and i64 %arg.scales.5.2, 1
  %154 = icmp eq i64 %153, 0
  br i1 %154, label %B526.else, label %B46.endif.endif.i.epil.preheader

B46.endif.endif.i.epil.preheader:                 ; preds = %B526.else.loopexit86.unr-lcssa, %B46.endif.endif.i.preheader
  %.epil.init = phi <8 x double> [ zeroinitializer, %B46.endif.endif.i.preheader ], [ %91, %B526.else.loopexit86.unr-lcssa ]
  %.epil.init92 = phi <8 x double> [ zeroinitializer, %B46.endif.endif.i.preheader ], [ %90, %B526.else.loopexit86.unr-lcssa ]
  %.epil.init94 = phi <8 x double> [ zeroinitializer, %B46.endif.endif.i.preheader ], [ %89, %B526.else.loopexit86.unr-lcssa ]
  %.epil.init96 = phi <8 x double> [ zeroinitializer, %B46.endif.endif.i.preheader ], [ %88, %B526.else.loopexit86.unr-lcssa ]
  %.epil.init98 = phi <8 x double> [ zeroinitializer, %B46.endif.endif.i.preheader ], [ %83, %B526.else.loopexit86.unr-lcssa ]
  %.epil.init100 = phi <8 x double> [ zeroinitializer, %B46.endif.endif.i.preheader ], [ %82, %B526.else.loopexit86.unr-lcssa ]
  %.epil.init102 = phi <8 x double> [ zeroinitializer, %B46.endif.endif.i.preheader ], [ %81, %B526.else.loopexit86.unr-lcssa ]
  %.epil.init104 = phi <8 x double> [ zeroinitializer, %B46.endif.endif.i.preheader ], [ %80, %B526.else.loopexit86.unr-lcssa ]
  %sunkaddr510 = mul i64 %unroll_iter107, 8
  %sunkaddr511 = getelementptr i8, ptr %arg.scales.5.4, i64 %sunkaddr510
  %.207.i.epil = load double, ptr %sunkaddr511, align 8, !noalias !311
  %155 = getelementptr double, ptr %29, i64 %.423.i.epil
  %broadcast.splatinsert.i.epil = insertelement <8 x double> poison, double %.207.i.epil, i64 0
  %broadcast.splat.i.epil = shufflevector <8 x double> %broadcast.splatinsert.i.epil, <8 x double> poison, <8 x i32> zeroinitializer
  %156 = getelementptr i8, ptr %155, i64 64
  %157 = getelementptr i8, ptr %155, i64 128
  %158 = getelementptr i8, ptr %155, i64 192
  %wide.load5.i.epil = load <8 x double>, ptr %155, align 8, !alias.scope !315, !noalias !311
  %wide.load6.i.epil = load <8 x double>, ptr %156, align 8, !alias.scope !315, !noalias !311
  %wide.load7.i.epil = load <8 x double>, ptr %157, align 8, !alias.scope !315, !noalias !311
  %wide.load8.i.epil = load <8 x double>, ptr %158, align 8, !alias.scope !315, !noalias !311
  %159 = fmul <8 x double> %wide.load5.i.epil, %broadcast.splat.i.epil
  %160 = fmul <8 x double> %broadcast.splat.i.epil, %wide.load6.i.epil
  %161 = fmul <8 x double> %broadcast.splat.i.epil, %wide.load7.i.epil
  %162 = fmul <8 x double> %broadcast.splat.i.epil, %wide.load8.i.epil
  %163 = fadd <8 x double> %.epil.init104, %159
  %164 = fadd <8 x double> %.epil.init102, %160
  %165 = fadd <8 x double> %.epil.init100, %161
  %166 = fadd <8 x double> %.epil.init98, %162
  store <8 x double> %163, ptr %arg.total.4, align 8, !alias.scope !318, !noalias !320
  %sunkaddr512 = getelementptr i8, ptr %arg.total.4, i64 64
  store <8 x double> %164, ptr %sunkaddr512, align 8, !alias.scope !318, !noalias !320
  %sunkaddr513 = getelementptr i8, ptr %arg.total.4, i64 128
  store <8 x double> %165, ptr %sunkaddr513, align 8, !alias.scope !318, !noalias !320
  %sunkaddr514 = getelementptr i8, ptr %arg.total.4, i64 192
  store <8 x double> %166, ptr %sunkaddr514, align 8, !alias.scope !318, !noalias !320
  %167 = getelementptr i8, ptr %155, i64 256
  %168 = getelementptr i8, ptr %155, i64 320
  %169 = getelementptr i8, ptr %155, i64 384
  %170 = getelementptr i8, ptr %155, i64 448
  %wide.load5.1.i.epil = load <8 x double>, ptr %167, align 8, !alias.scope !315, !noalias !311
  %wide.load6.1.i.epil = load <8 x double>, ptr %168, align 8, !alias.scope !315, !noalias !311
  %wide.load7.1.i.epil = load <8 x double>, ptr %169, align 8, !alias.scope !315, !noalias !311
  %wide.load8.1.i.epil = load <8 x double>, ptr %170, align 8, !alias.scope !315, !noalias !311
  %171 = fmul <8 x double> %broadcast.splat.i.epil, %wide.load5.1.i.epil
  %172 = fmul <8 x double> %broadcast.splat.i.epil, %wide.load6.1.i.epil
  %173 = fmul <8 x double> %broadcast.splat.i.epil, %wide.load7.1.i.epil
  %174 = fmul <8 x double> %broadcast.splat.i.epil, %wide.load8.1.i.epil
  %175 = fadd <8 x double> %.epil.init96, %171
  %176 = fadd <8 x double> %.epil.init94, %172
  %177 = fadd <8 x double> %.epil.init92, %173
  %178 = fadd <8 x double> %.epil.init, %174
  %sunkaddr515 = getelementptr i8, ptr %arg.total.4, i64 256
  store <8 x double> %175, ptr %sunkaddr515, align 8, !alias.scope !318, !noalias !320
  %sunkaddr516 = getelementptr i8, ptr %arg.total.4, i64 320
  store <8 x double> %176, ptr %sunkaddr516, align 8, !alias.scope !318, !noalias !320
  %sunkaddr517 = getelementptr i8, ptr %arg.total.4, i64 384
  store <8 x double> %177, ptr %sunkaddr517, align 8, !alias.scope !318, !noalias !320
  %sunkaddr518 = getelementptr i8, ptr %arg.total.4, i64 448
  store <8 x double> %178, ptr %sunkaddr518, align 8, !alias.scope !318, !noalias !320
  br label %B526.else

B526.else:                                        ; preds = %B44.loopexit.loopexit.us.i, %B46.endif.endif.i.epil.preheader, %B526.else.loopexit86.unr-lcssa, %B480, %B352, %B352
  %179 = icmp slt i64 %.530, 0
  %.1181 = shl i64 %.530, 6
  %.1186 = add i64 %.1181, 64
  %.1224 = select i1 %179, i64 %arg.z.5.0, i64 0
  %.1225 = add i64 %.1224, %.1181
  %.1228 = icmp slt i64 %.1225, 0
  br i1 %.1228, label %B526.else.if, label %B526.else.endif, !prof !11

B526.else.if:                                     ; preds = %B526.else
  br label %B526.else.endif

B526.else.endif:                                  ; preds = %B526.else.if, %B526.else
  %.1213.sroa.0.1 = phi i64 [ 0, %B526.else.if ], [ %.1225, %B526.else ]
  %.1233.not = icmp slt i64 %.1225, %arg.z.5.0
  br i1 %.1233.not, label %B526.else.endif.endif, label %B526.else.endif.if, !prof !12

B526.else.endif.if:                               ; preds = %B526.else.endif
  br label %B526.else.endif.endif

B526.else.endif.endif:                            ; preds = %B526.else.endif.if, %B526.else.endif
  %.1213.sroa.0.3 = phi i64 [ %arg.z.5.0, %B526.else.endif.if ], [ %.1213.sroa.0.1, %B526.else.endif ]
  %.1240 = icmp slt i64 %.1186, 0
  %.1241 = select i1 %.1240, i64 %arg.z.5.0, i64 0
  %.1242 = add i64 %.1241, %.1186
  %.1245 = icmp slt i64 %.1242, 0
  br i1 %.1245, label %B526.else.endif.endif.if, label %B526.else.endif.endif.endif, !prof !11

B526.else.endif.endif.if:                         ; preds = %B526.else.endif.endif
  br label %B526.else.endif.endif.endif

B526.else.endif.endif.endif:                      ; preds = %B526.else.endif.endif.if, %B526.else.endif.endif
  %.1213.sroa.13.1 = phi i64 [ 0, %B526.else.endif.endif.if ], [ %.1242, %B526.else.endif.endif ]
  %.1250.not = icmp slt i64 %.1242, %arg.z.5.0
  br i1 %.1250.not, label %B526.endif.endif, label %B526.else.endif.endif.endif.if, !prof !12

B526.else.endif.endif.endif.if:                   ; preds = %B526.else.endif.endif.endif
  br label %B526.endif.endif

B526.endif.endif:                                 ; preds = %B526.else.endif.endif.endif.if, %B526.else.endif.endif.endif
  %.1213.sroa.13.0 = phi i64 [ %.1213.sroa.13.1, %B526.else.endif.endif.endif ], [ %arg.z.5.0, %B526.else.endif.endif.endif.if ]
  %.1301 = sub i64 %.1213.sroa.13.0, %.1213.sroa.0.3
  %.1310 = tail call i64 @llvm.smax.i64(i64 %.1301, i64 0)
  %.1326 = getelementptr double, ptr %arg.z.4, i64 %.1213.sroa.0.3
  %.1444839.not = icmp slt i64 %.1301, 1
  %.pre = mul i64 %.465853896, %arg.c.5.1
  br i1 %.1444839.not, label %iter.check, label %iter.check30

iter.check30:                                     ; preds = %B526.endif.endif
  %min.iters.check28 = icmp samesign ult i64 %.1301, 4
  br i1 %min.iters.check28, label %B626.preheader, label %vector.memcheck

vector.memcheck:                                  ; preds = %iter.check30
  %180 = ptrtoint ptr %arg.c.4 to i64
  %181 = ptrtoint ptr %arg.z.4 to i64
  %182 = shl i64 %.1213.sroa.0.3, 3
  %183 = add i64 %5, %180
  %184 = add i64 %182, %181
  %185 = sub i64 %183, %184
  %diff.check = icmp ult i64 %185, 256
  %diff.check27 = icmp ult i64 %6, 256
  %conflict.rdx = or i1 %diff.check27, %diff.check
  br i1 %conflict.rdx, label %B626.preheader, label %vector.main.loop.iter.check32

vector.main.loop.iter.check32:                    ; preds = %vector.memcheck
  %min.iters.check31 = icmp samesign ult i64 %.1301, 32
  br i1 %min.iters.check31, label %vec.epilog.ph52, label %vector.ph33

vector.ph33:                                      ; preds = %vector.main.loop.iter.check32
  %n.vec35 = and i64 %.1301, %const356
  %scevgep230 = getelementptr i8, ptr %scevgep229, i64 %182
  br label %vector.body36

vector.body36:                                    ; preds = %vector.body36, %vector.ph33
  %index37 = phi i64 [ 0, %vector.ph33 ], [ %index.next45, %vector.body36 ]
  %186 = shl i64 %index37, 3
  %scevgep231 = getelementptr i8, ptr %scevgep230, i64 %186
  %scevgep232 = getelementptr i8, ptr %scevgep231, i64 -192
  %scevgep234 = getelementptr i8, ptr %scevgep231, i64 -128
  %scevgep233 = getelementptr i8, ptr %scevgep231, i64 -64
  %wide.load = load <8 x double>, ptr %scevgep232, align 8
  %wide.load38 = load <8 x double>, ptr %scevgep234, align 8
  %wide.load39 = load <8 x double>, ptr %scevgep233, align 8
  %wide.load40 = load <8 x double>, ptr %scevgep231, align 8
  %sunkaddr519 = mul i64 %index37, 8
  %sunkaddr520 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr519
  %wide.load41 = load <8 x double>, ptr %sunkaddr520, align 8
  %sunkaddr521 = mul i64 %index37, 8
  %sunkaddr522 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr521
  %sunkaddr523 = getelementptr i8, ptr %sunkaddr522, i64 64
  %wide.load42 = load <8 x double>, ptr %sunkaddr523, align 8
  %sunkaddr524 = mul i64 %index37, 8
  %sunkaddr525 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr524
  %sunkaddr526 = getelementptr i8, ptr %sunkaddr525, i64 128
  %wide.load43 = load <8 x double>, ptr %sunkaddr526, align 8
  %sunkaddr527 = mul i64 %index37, 8
  %sunkaddr528 = getelementptr i8, ptr %arg.total.4, i64 %sunkaddr527
  %sunkaddr529 = getelementptr i8, ptr %sunkaddr528, i64 192
  %wide.load44 = load <8 x double>, ptr %sunkaddr529, align 8
  %187 = fsub <8 x double> %wide.load, %wide.load41
  %188 = fsub <8 x double> %wide.load38, %wide.load42
  %189 = fsub <8 x double> %wide.load39, %wide.load43
  %190 = fsub <8 x double> %wide.load40, %wide.load44
  %191 = shl i64 %index37, 3
  %scevgep220 = getelementptr i8, ptr %lsr.iv218, i64 %191
  %scevgep221 = getelementptr i8, ptr %scevgep220, i64 -192
  %scevgep223 = getelementptr i8, ptr %scevgep220, i64 -128
  %scevgep222 = getelementptr i8, ptr %scevgep220, i64 -64
  store <8 x double> %187, ptr %scevgep221, align 8
  store <8 x double> %188, ptr %scevgep223, align 8
  store <8 x double> %189, ptr %scevgep222, align 8
  store <8 x double> %190, ptr %scevgep220, align 8
  %index.next45 = add nuw i64 %index37, 32
  %192 = icmp eq i64 %n.vec35, %index.next45
  br i1 %192, label %middle.block46, label %vector.body36, !llvm.loop !333

middle.block46:                                   ; preds = %vector.body36
  %cmp.n47 = icmp eq i64 %.1301, %n.vec35
  br i1 %cmp.n47, label %B674.endif, label %vec.epilog.iter.check50

vec.epilog.iter.check50:                          ; preds = %middle.block46
  %n.mod.vf34 = and i64 %.1301, 28
  %min.epilog.iters.check51 = icmp eq i64 %n.mod.vf34, 0
  br i1 %min.epilog.iters.check51, label %B626.preheader, label %vec.epilog.ph52, !prof !91

vec.epilog.ph52:                                  ; preds = %vec.epilog.iter.check50, %vector.main.loop.iter.check32
  %vec.epilog.resume.val48 = phi i64 [ %n.vec35, %vec.epilog.iter.check50 ], [ 0, %vector.main.loop.iter.check32 ]
  %const_mat357 = add i64 %const356, 28
  %n.vec54 = and i64 %.1301, %const_mat357
  br label %vec.epilog.vector.body55

vec.epilog.vector.body55:                         ; preds = %vec.epilog.vector.body55, %vec.epilog.ph52
  %index56 = phi i64 [ %vec.epilog.resume.val48, %vec.epilog.ph52 ], [ %index.next59, %vec.epilog.vector.body55 ]
  %193 = shl i64 %index56, 3
  %scevgep239 = getelementptr i8, ptr %.1326, i64 %193
  %wide.load57 = load <4 x double>, ptr %scevgep239, align 8
  %194 = shl i64 %index56, 3
  %scevgep238 = getelementptr i8, ptr %arg.total.4, i64 %194
  %wide.load58 = load <4 x double>, ptr %scevgep238, align 8
  %195 = fsub <4 x double> %wide.load57, %wide.load58
  %196 = shl i64 %index56, 3
  %scevgep237 = getelementptr i8, ptr %lsr.iv235, i64 %196
  store <4 x double> %195, ptr %scevgep237, align 8
  %index.next59 = add nuw i64 %index56, 4
  %197 = icmp eq i64 %n.vec54, %index.next59
  br i1 %197, label %vec.epilog.middle.block60, label %vec.epilog.vector.body55, !llvm.loop !334

vec.epilog.middle.block60:                        ; preds = %vec.epilog.vector.body55
  %cmp.n61 = icmp eq i64 %.1301, %n.vec54
  br i1 %cmp.n61, label %B674.endif, label %B626.preheader

B626.preheader:                                   ; preds = %vec.epilog.middle.block60, %vec.epilog.iter.check50, %vector.memcheck, %iter.check30
  %.1450838840.ph = phi i64 [ 0, %iter.check30 ], [ 0, %vector.memcheck ], [ %n.vec35, %vec.epilog.iter.check50 ], [ %n.vec54, %vec.epilog.middle.block60 ]
  %198 = add i64 %.1213.sroa.0.3, %.1450838840.ph
  %199 = sub i64 %.1213.sroa.13.0, %198
  %xtraiter109 = and i64 %199, 7
  %lcmp.mod110.not = icmp eq i64 %xtraiter109, 0
  br i1 %lcmp.mod110.not, label %B626.prol.loopexit, label %B626.prol.preheader

B626.prol.preheader:                              ; preds = %B626.preheader
  br label %B626.prol

B626.prol:                                        ; preds = %B626.prol.preheader, %B626.prol
  %lsr.iv243 = phi i64 [ %xtraiter109, %B626.prol.preheader ], [ %lsr.iv.next, %B626.prol ]
  %.1450838840.prol = phi i64 [ %.1457.prol, %B626.prol ], [ %.1450838840.ph, %B626.prol.preheader ]
  %.1457.prol = add nuw i64 %.1450838840.prol, 1
  %200 = shl i64 %.1450838840.prol, 3
  %scevgep242 = getelementptr i8, ptr %.1326, i64 %200
  %.1511.prol = load double, ptr %scevgep242, align 8
  %201 = shl i64 %.1450838840.prol, 3
  %scevgep241 = getelementptr i8, ptr %arg.total.4, i64 %201
  %.1541.prol = load double, ptr %scevgep241, align 8
  %.1542.prol = fsub double %.1511.prol, %.1541.prol
  %202 = shl i64 %.1450838840.prol, 3
  %scevgep240 = getelementptr i8, ptr %lsr.iv235, i64 %202
  store double %.1542.prol, ptr %scevgep240, align 8
  %lsr.iv.next = add nsw i64 %lsr.iv243, -1
  %prol.iter.cmp.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %prol.iter.cmp.not, label %B626.prol.loopexit, label %B626.prol, !llvm.loop !335

B626.prol.loopexit:                               ; preds = %B626.prol, %B626.preheader
  %.1450838840.unr = phi i64 [ %.1450838840.ph, %B626.preheader ], [ %.1457.prol, %B626.prol ]
  %203 = sub i64 %.1213.sroa.0.3, %.1213.sroa.13.0
  %204 = add i64 %203, %.1450838840.ph
  %205 = icmp ugt i64 %204, -8
  br i1 %205, label %B674.endif, label %B626.preheader63

B626.preheader63:                                 ; preds = %B626.prol.loopexit
  %206 = shl i64 %.1213.sroa.0.3, 3
  %scevgep276 = getelementptr i8, ptr %scevgep275, i64 %206
  br label %B626

B674.endif:                                       ; preds = %B626, %B626.prol.loopexit, %vec.epilog.middle.block60, %middle.block46
  %.1687846928 = icmp samesign ult i64 %.1301, 64
  br i1 %.1687846928, label %iter.check, label %B138.loopexit

iter.check:                                       ; preds = %B674.endif, %B526.endif.endif
  %.1644 = sub nsw i64 64, %.1310
  %207 = getelementptr double, ptr %arg.c.4, i64 %.pre
  %smin = tail call i64 @llvm.smin.i64(i64 %.1644, i64 1)
  %208 = add i64 %.1310, %smin
  %209 = sub i64 65, %208
  %min.iters.check = icmp ult i64 %209, 8
  br i1 %min.iters.check, label %B728.preheader, label %vector.main.loop.iter.check

B728.preheader:                                   ; preds = %vec.epilog.middle.block, %vec.epilog.iter.check, %iter.check
  %.1686844848.ph = phi i64 [ %.1644, %iter.check ], [ %ind.end, %vec.epilog.iter.check ], [ %235, %vec.epilog.middle.block ]
  %.1693845847.ph = phi i64 [ %.1310, %iter.check ], [ %228, %vec.epilog.iter.check ], [ %236, %vec.epilog.middle.block ]
  %210 = add i64 %.1686844848.ph, 1
  br label %B728

vector.main.loop.iter.check:                      ; preds = %iter.check
  %min.iters.check6 = icmp ult i64 %209, 32
  br i1 %min.iters.check6, label %vec.epilog.ph, label %vector.ph

vector.ph:                                        ; preds = %vector.main.loop.iter.check
  %n.vec = and i64 %209, -32
  %broadcast.splatinsert7 = insertelement <8 x i64> poison, i64 %.1310, i64 0
  %broadcast.splat8 = shufflevector <8 x i64> %broadcast.splatinsert7, <8 x i64> poison, <8 x i32> zeroinitializer
  %induction = add nuw <8 x i64> %broadcast.splat8, <i64 0, i64 1, i64 2, i64 3, i64 4, i64 5, i64 6, i64 7>
  br label %vector.body

vector.body:                                      ; preds = %vector.body, %vector.ph
  %lsr.iv292 = phi i64 [ %lsr.iv.next293, %vector.body ], [ %n.vec, %vector.ph ]
  %vec.ind = phi <8 x i64> [ %induction, %vector.ph ], [ %vec.ind.next, %vector.body ]
  %step.add = add <8 x i64> %vec.ind, splat (i64 8)
  %step.add.2 = add <8 x i64> %vec.ind, splat (i64 16)
  %step.add.3 = add <8 x i64> %vec.ind, splat (i64 24)
  %211 = icmp slt <8 x i64> %vec.ind, zeroinitializer
  %212 = icmp slt <8 x i64> %step.add, zeroinitializer
  %213 = icmp slt <8 x i64> %step.add.2, zeroinitializer
  %214 = icmp slt <8 x i64> %step.add.3, zeroinitializer
  %215 = select <8 x i1> %211, <8 x i64> %broadcast.splat, <8 x i64> zeroinitializer
  %216 = select <8 x i1> %212, <8 x i64> %broadcast.splat, <8 x i64> zeroinitializer
  %217 = select <8 x i1> %213, <8 x i64> %broadcast.splat, <8 x i64> zeroinitializer
  %218 = select <8 x i1> %214, <8 x i64> %broadcast.splat, <8 x i64> zeroinitializer
  %219 = getelementptr double, ptr %207, <8 x i64> %vec.ind
  %220 = getelementptr double, ptr %207, <8 x i64> %step.add
  %221 = getelementptr double, ptr %207, <8 x i64> %step.add.2
  %222 = getelementptr double, ptr %207, <8 x i64> %step.add.3
  %223 = getelementptr double, <8 x ptr> %219, <8 x i64> %215
  %224 = getelementptr double, <8 x ptr> %220, <8 x i64> %216
  %225 = getelementptr double, <8 x ptr> %221, <8 x i64> %217
  %226 = getelementptr double, <8 x ptr> %222, <8 x i64> %218
  tail call void @llvm.masked.scatter.v8f64.v8p0(<8 x double> splat (double 0x7FF0000000000000), <8 x ptr> align 8 %223, <8 x i1> splat (i1 true))
  tail call void @llvm.masked.scatter.v8f64.v8p0(<8 x double> splat (double 0x7FF0000000000000), <8 x ptr> align 8 %224, <8 x i1> splat (i1 true))
  tail call void @llvm.masked.scatter.v8f64.v8p0(<8 x double> splat (double 0x7FF0000000000000), <8 x ptr> align 8 %225, <8 x i1> splat (i1 true))
  tail call void @llvm.masked.scatter.v8f64.v8p0(<8 x double> splat (double 0x7FF0000000000000), <8 x ptr> align 8 %226, <8 x i1> splat (i1 true))
  %vec.ind.next = add <8 x i64> %vec.ind, splat (i64 32)
  %lsr.iv.next293 = add i64 %lsr.iv292, -32
  %227 = icmp eq i64 %lsr.iv.next293, 0
  br i1 %227, label %middle.block, label %vector.body, !llvm.loop !336

middle.block:                                     ; preds = %vector.body
  %cmp.n = icmp eq i64 %209, %n.vec
  br i1 %cmp.n, label %B138.loopexit, label %vec.epilog.iter.check

vec.epilog.iter.check:                            ; preds = %middle.block
  %228 = add i64 %n.vec, %.1310
  %n.mod.vf = and i64 %209, 24
  %ind.end = sub i64 %.1644, %n.vec
  %min.epilog.iters.check = icmp eq i64 %n.mod.vf, 0
  br i1 %min.epilog.iters.check, label %B728.preheader, label %vec.epilog.ph, !prof !295

vec.epilog.ph:                                    ; preds = %vec.epilog.iter.check, %vector.main.loop.iter.check
  %vec.epilog.resume.val = phi i64 [ %n.vec, %vec.epilog.iter.check ], [ 0, %vector.main.loop.iter.check ]
  %bc.resume.val = phi i64 [ %228, %vec.epilog.iter.check ], [ %.1310, %vector.main.loop.iter.check ]
  %n.vec10 = and i64 %209, -8
  %broadcast.splatinsert13 = insertelement <8 x i64> poison, i64 %bc.resume.val, i64 0
  %broadcast.splat14 = shufflevector <8 x i64> %broadcast.splatinsert13, <8 x i64> poison, <8 x i32> zeroinitializer
  %induction15 = add nuw <8 x i64> %broadcast.splat14, <i64 0, i64 1, i64 2, i64 3, i64 4, i64 5, i64 6, i64 7>
  %229 = sub i64 %vec.epilog.resume.val, %n.vec10
  br label %vec.epilog.vector.body

vec.epilog.vector.body:                           ; preds = %vec.epilog.vector.body, %vec.epilog.ph
  %lsr.iv294 = phi i64 [ %lsr.iv.next295, %vec.epilog.vector.body ], [ %229, %vec.epilog.ph ]
  %vec.ind17 = phi <8 x i64> [ %induction15, %vec.epilog.ph ], [ %vec.ind.next19, %vec.epilog.vector.body ]
  %230 = icmp slt <8 x i64> %vec.ind17, zeroinitializer
  %231 = select <8 x i1> %230, <8 x i64> %broadcast.splat, <8 x i64> zeroinitializer
  %232 = getelementptr double, ptr %207, <8 x i64> %vec.ind17
  %233 = getelementptr double, <8 x ptr> %232, <8 x i64> %231
  tail call void @llvm.masked.scatter.v8f64.v8p0(<8 x double> splat (double 0x7FF0000000000000), <8 x ptr> align 8 %233, <8 x i1> splat (i1 true))
  %vec.ind.next19 = add nuw <8 x i64> %vec.ind17, splat (i64 8)
  %lsr.iv.next295 = add i64 %lsr.iv294, 8
  %234 = icmp eq i64 %lsr.iv.next295, 0
  br i1 %234, label %vec.epilog.middle.block, label %vec.epilog.vector.body, !llvm.loop !337

vec.epilog.middle.block:                          ; preds = %vec.epilog.vector.body
  %235 = sub i64 %.1644, %n.vec10
  %236 = add i64 %n.vec10, %.1310
  %cmp.n20 = icmp eq i64 %209, %n.vec10
  br i1 %cmp.n20, label %B138.loopexit, label %B728.preheader
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define linkonce_odr noundef i32 @_ZN18elastomer_friction7kernels8rheology6scaled19_settle_and_predictB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.ahead.0, ptr readnone captures(none) %arg.ahead.1, i64 %arg.ahead.2, i64 %arg.ahead.3, ptr readonly captures(none) %arg.ahead.4, i64 %arg.ahead.5.0, i64 %arg.ahead.6.0, ptr readnone captures(none) %arg.fresh.0, ptr readnone captures(none) %arg.fresh.1, i64 %arg.fresh.2, i64 %arg.fresh.3, ptr readonly captures(none) %arg.fresh.4, i64 %arg.fresh.5.0, i64 %arg.fresh.6.0, ptr readnone captures(none) %arg.stale.0, ptr readnone captures(none) %arg.stale.1, i64 %arg.stale.2, i64 %arg.stale.3, ptr readonly captures(none) %arg.stale.4, i64 %arg.stale.5.0, i64 %arg.stale.6.0, ptr readnone captures(none) %arg.memory.0, ptr readnone captures(none) %arg.memory.1, i64 %arg.memory.2, i64 %arg.memory.3, ptr captures(none) %arg.memory.4, i64 %arg.memory.5.0, i64 %arg.memory.5.1, i64 %arg.memory.5.2, i64 %arg.memory.6.0, i64 %arg.memory.6.1, i64 %arg.memory.6.2, i64 %arg.b, ptr readnone captures(none) %arg.total.0, ptr readnone captures(none) %arg.total.1, i64 %arg.total.2, i64 %arg.total.3, ptr captures(none) %arg.total.4, i64 %arg.total.5.0, i64 %arg.total.6.0) local_unnamed_addr #9 {
B0.endif:
  %.158284.not = icmp slt i64 %arg.ahead.2, 1
  br i1 %.158284.not, label %B306, label %B46.endif.endif.lr.ph

B46.endif.endif.lr.ph:                            ; preds = %B0.endif
  %.449 = icmp slt i64 %arg.b, 0
  %.450 = select i1 %.449, i64 %arg.memory.5.0, i64 0
  %.451 = add i64 %.450, %arg.b
  %.479 = mul i64 %arg.memory.5.2, %arg.memory.5.1
  %.481 = mul i64 %.479, %.451
  %0 = getelementptr double, ptr %arg.memory.4, i64 %.481
  %1 = mul i64 %.451, %arg.memory.5.1
  %2 = add i64 %1, %arg.ahead.2
  %3 = shl i64 %2, 3
  %4 = add i64 %3, -8
  %5 = mul i64 %4, %arg.memory.5.2
  %6 = getelementptr i8, ptr %arg.memory.4, i64 %5
  %scevgep = getelementptr i8, ptr %6, i64 512
  %scevgep1 = getelementptr i8, ptr %arg.total.4, i64 1536
  %bound0 = icmp ult ptr %0, %scevgep1
  %bound1 = icmp ult ptr %arg.total.4, %scevgep
  %found.conflict = and i1 %bound0, %bound1
  %.mask = and i64 %arg.memory.5.2, 1152921504606846976
  %stride.check = icmp ne i64 %.mask, 0
  %7 = or i1 %stride.check, %found.conflict
  br i1 %7, label %B46.endif.endif.us.preheader, label %B46.endif.endif.lr.ph.split

B46.endif.endif.us.preheader:                     ; preds = %B46.endif.endif.lr.ph
  %8 = mul i64 %arg.memory.5.2, %arg.memory.5.1
  %9 = mul i64 %8, %.451
  %10 = shl i64 %9, 3
  %11 = add i64 %10, 24
  %scevgep31 = getelementptr i8, ptr %arg.memory.4, i64 %11
  %12 = shl i64 %arg.memory.5.2, 3
  br label %B46.endif.endif.us

B46.endif.endif.us:                               ; preds = %B46.endif.endif.us.preheader, %B44.loopexit.loopexit.us
  %lsr.iv = phi ptr [ %scevgep31, %B46.endif.endif.us.preheader ], [ %scevgep32, %B44.loopexit.loopexit.us ]
  %.164280285.us = phi i64 [ %.171.us, %B44.loopexit.loopexit.us ], [ 0, %B46.endif.endif.us.preheader ]
  %13 = getelementptr double, ptr %arg.ahead.4, i64 %.164280285.us
  %.229.us = load double, ptr %13, align 8
  %14 = getelementptr double, ptr %arg.fresh.4, i64 %.164280285.us
  %.260.us = load double, ptr %14, align 8
  %15 = getelementptr double, ptr %arg.stale.4, i64 %.164280285.us
  %.291.us = load double, ptr %15, align 8
  br label %B138.us

B138.us:                                          ; preds = %B138.us, %B46.endif.endif.us
  %.386275277.us = phi i64 [ %.393.3.us, %B138.us ], [ 0, %B46.endif.endif.us ]
  %16 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep36 = getelementptr i8, ptr %lsr.iv, i64 %16
  %scevgep37 = getelementptr i8, ptr %scevgep36, i64 -24
  %.488.us = load double, ptr %scevgep37, align 8
  %17 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep20 = getelementptr i8, ptr %arg.total.4, i64 %17
  %18 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep23 = getelementptr i8, ptr %arg.total.4, i64 %18
  %scevgep24 = getelementptr i8, ptr %scevgep23, i64 512
  %.519.us = load double, ptr %scevgep24, align 8
  %.521.us = fmul double %.260.us, %.519.us
  %.522.us = fsub double %.488.us, %.521.us
  %19 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep21 = getelementptr i8, ptr %arg.total.4, i64 %19
  %scevgep22 = getelementptr i8, ptr %scevgep21, i64 1024
  %.554.us = load double, ptr %scevgep22, align 8
  %.556.us = fmul double %.291.us, %.554.us
  %.557.us = fsub double %.522.us, %.556.us
  store double %.557.us, ptr %scevgep37, align 8
  %.658.us = load double, ptr %scevgep20, align 8
  %.660.us = fmul double %.229.us, %.557.us
  %.661.us = fadd double %.658.us, %.660.us
  store double %.661.us, ptr %scevgep20, align 8
  %20 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep38 = getelementptr i8, ptr %lsr.iv, i64 %20
  %scevgep39 = getelementptr i8, ptr %scevgep38, i64 -16
  %.488.1.us = load double, ptr %scevgep39, align 8
  %21 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep25 = getelementptr i8, ptr %arg.total.4, i64 %21
  %scevgep26 = getelementptr i8, ptr %scevgep25, i64 8
  %22 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep29 = getelementptr i8, ptr %arg.total.4, i64 %22
  %scevgep30 = getelementptr i8, ptr %scevgep29, i64 520
  %.519.1.us = load double, ptr %scevgep30, align 8
  %.521.1.us = fmul double %.260.us, %.519.1.us
  %.522.1.us = fsub double %.488.1.us, %.521.1.us
  %23 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep27 = getelementptr i8, ptr %arg.total.4, i64 %23
  %scevgep28 = getelementptr i8, ptr %scevgep27, i64 1032
  %.554.1.us = load double, ptr %scevgep28, align 8
  %.556.1.us = fmul double %.291.us, %.554.1.us
  %.557.1.us = fsub double %.522.1.us, %.556.1.us
  store double %.557.1.us, ptr %scevgep39, align 8
  %.658.1.us = load double, ptr %scevgep26, align 8
  %.660.1.us = fmul double %.229.us, %.557.1.us
  %.661.1.us = fadd double %.658.1.us, %.660.1.us
  store double %.661.1.us, ptr %scevgep26, align 8
  %24 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep34 = getelementptr i8, ptr %lsr.iv, i64 %24
  %scevgep35 = getelementptr i8, ptr %scevgep34, i64 -8
  %.488.2.us = load double, ptr %scevgep35, align 8
  %25 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep14 = getelementptr i8, ptr %arg.total.4, i64 %25
  %scevgep15 = getelementptr i8, ptr %scevgep14, i64 16
  %26 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep18 = getelementptr i8, ptr %arg.total.4, i64 %26
  %scevgep19 = getelementptr i8, ptr %scevgep18, i64 528
  %.519.2.us = load double, ptr %scevgep19, align 8
  %.521.2.us = fmul double %.260.us, %.519.2.us
  %.522.2.us = fsub double %.488.2.us, %.521.2.us
  %27 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep16 = getelementptr i8, ptr %arg.total.4, i64 %27
  %scevgep17 = getelementptr i8, ptr %scevgep16, i64 1040
  %.554.2.us = load double, ptr %scevgep17, align 8
  %.556.2.us = fmul double %.291.us, %.554.2.us
  %.557.2.us = fsub double %.522.2.us, %.556.2.us
  store double %.557.2.us, ptr %scevgep35, align 8
  %.658.2.us = load double, ptr %scevgep15, align 8
  %.660.2.us = fmul double %.229.us, %.557.2.us
  %.661.2.us = fadd double %.658.2.us, %.660.2.us
  store double %.661.2.us, ptr %scevgep15, align 8
  %.393.3.us = add nuw nsw i64 %.386275277.us, 4
  %28 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep33 = getelementptr i8, ptr %lsr.iv, i64 %28
  %.488.3.us = load double, ptr %scevgep33, align 8
  %29 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep8 = getelementptr i8, ptr %arg.total.4, i64 %29
  %scevgep9 = getelementptr i8, ptr %scevgep8, i64 24
  %30 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep12 = getelementptr i8, ptr %arg.total.4, i64 %30
  %scevgep13 = getelementptr i8, ptr %scevgep12, i64 536
  %.519.3.us = load double, ptr %scevgep13, align 8
  %.521.3.us = fmul double %.260.us, %.519.3.us
  %.522.3.us = fsub double %.488.3.us, %.521.3.us
  %31 = shl nuw nsw i64 %.386275277.us, 3
  %scevgep10 = getelementptr i8, ptr %arg.total.4, i64 %31
  %scevgep11 = getelementptr i8, ptr %scevgep10, i64 1048
  %.554.3.us = load double, ptr %scevgep11, align 8
  %.556.3.us = fmul double %.291.us, %.554.3.us
  %.557.3.us = fsub double %.522.3.us, %.556.3.us
  store double %.557.3.us, ptr %scevgep33, align 8
  %.658.3.us = load double, ptr %scevgep9, align 8
  %.660.3.us = fmul double %.229.us, %.557.3.us
  %.661.3.us = fadd double %.658.3.us, %.660.3.us
  store double %.661.3.us, ptr %scevgep9, align 8
  %exitcond.not.3.us = icmp eq i64 %.393.3.us, 64
  br i1 %exitcond.not.3.us, label %B44.loopexit.loopexit.us, label %B138.us, !llvm.loop !338

B44.loopexit.loopexit.us:                         ; preds = %B138.us
  %.171.us = add nuw nsw i64 %.164280285.us, 1
  %scevgep32 = getelementptr i8, ptr %lsr.iv, i64 %12
  %exitcond290.not.us = icmp eq i64 %.171.us, %arg.ahead.2
  br i1 %exitcond290.not.us, label %B306, label %B46.endif.endif.us

B46.endif.endif.lr.ph.split:                      ; preds = %B46.endif.endif.lr.ph
  %32 = getelementptr i8, ptr %arg.total.4, i64 1472
  %33 = getelementptr i8, ptr %arg.total.4, i64 1408
  %34 = getelementptr i8, ptr %arg.total.4, i64 960
  %35 = getelementptr i8, ptr %arg.total.4, i64 896
  %36 = getelementptr i8, ptr %arg.total.4, i64 1344
  %37 = getelementptr i8, ptr %arg.total.4, i64 1280
  %38 = getelementptr i8, ptr %arg.total.4, i64 832
  %39 = getelementptr i8, ptr %arg.total.4, i64 768
  %40 = getelementptr i8, ptr %arg.total.4, i64 1216
  %41 = getelementptr i8, ptr %arg.total.4, i64 1152
  %42 = getelementptr i8, ptr %arg.total.4, i64 704
  %43 = getelementptr i8, ptr %arg.total.4, i64 640
  %44 = getelementptr i8, ptr %arg.total.4, i64 1088
  %45 = getelementptr i8, ptr %arg.total.4, i64 1024
  %46 = getelementptr i8, ptr %arg.total.4, i64 576
  %47 = getelementptr i8, ptr %arg.total.4, i64 512
  %arg.total.4.promoted = load <8 x double>, ptr %arg.total.4, align 8, !alias.scope !339
  %sunkaddr = getelementptr i8, ptr %arg.total.4, i64 64
  %.promoted = load <8 x double>, ptr %sunkaddr, align 8, !alias.scope !339
  %sunkaddr53 = getelementptr i8, ptr %arg.total.4, i64 128
  %.promoted1 = load <8 x double>, ptr %sunkaddr53, align 8, !alias.scope !339
  %sunkaddr54 = getelementptr i8, ptr %arg.total.4, i64 192
  %.promoted2 = load <8 x double>, ptr %sunkaddr54, align 8, !alias.scope !339
  %sunkaddr55 = getelementptr i8, ptr %arg.total.4, i64 256
  %.promoted3 = load <8 x double>, ptr %sunkaddr55, align 8, !alias.scope !339
  %sunkaddr56 = getelementptr i8, ptr %arg.total.4, i64 320
  %.promoted4 = load <8 x double>, ptr %sunkaddr56, align 8, !alias.scope !339
  %sunkaddr57 = getelementptr i8, ptr %arg.total.4, i64 384
  %.promoted5 = load <8 x double>, ptr %sunkaddr57, align 8, !alias.scope !339
  %sunkaddr58 = getelementptr i8, ptr %arg.total.4, i64 448
  %.promoted6 = load <8 x double>, ptr %sunkaddr58, align 8, !alias.scope !339
  %wide.load7.pre = load <8 x double>, ptr %47, align 8, !alias.scope !339
  %wide.load8.pre = load <8 x double>, ptr %46, align 8, !alias.scope !339
  %wide.load9.pre = load <8 x double>, ptr %45, align 8, !alias.scope !339
  %wide.load10.pre = load <8 x double>, ptr %44, align 8, !alias.scope !339
  %wide.load7.1.pre = load <8 x double>, ptr %43, align 8, !alias.scope !339
  %wide.load8.1.pre = load <8 x double>, ptr %42, align 8, !alias.scope !339
  %wide.load9.1.pre = load <8 x double>, ptr %41, align 8, !alias.scope !339
  %wide.load10.1.pre = load <8 x double>, ptr %40, align 8, !alias.scope !339
  %wide.load7.2.pre = load <8 x double>, ptr %39, align 8, !alias.scope !339
  %wide.load8.2.pre = load <8 x double>, ptr %38, align 8, !alias.scope !339
  %wide.load9.2.pre = load <8 x double>, ptr %37, align 8, !alias.scope !339
  %wide.load10.2.pre = load <8 x double>, ptr %36, align 8, !alias.scope !339
  %wide.load7.3.pre = load <8 x double>, ptr %35, align 8, !alias.scope !339
  %wide.load8.3.pre = load <8 x double>, ptr %34, align 8, !alias.scope !339
  %wide.load9.3.pre = load <8 x double>, ptr %33, align 8, !alias.scope !339
  %wide.load10.3.pre = load <8 x double>, ptr %32, align 8, !alias.scope !339
  %48 = mul i64 %arg.memory.5.2, %arg.memory.5.1
  %49 = mul i64 %48, %.451
  %50 = shl i64 %49, 3
  %51 = add i64 %50, 448
  %scevgep40 = getelementptr i8, ptr %arg.memory.4, i64 %51
  %52 = shl i64 %arg.memory.5.2, 3
  br label %B46.endif.endif

B306:                                             ; preds = %B46.endif.endif, %B44.loopexit.loopexit.us, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B46.endif.endif:                                  ; preds = %B46.endif.endif, %B46.endif.endif.lr.ph.split
  %lsr.iv41 = phi ptr [ %scevgep42, %B46.endif.endif ], [ %scevgep40, %B46.endif.endif.lr.ph.split ]
  %53 = phi <8 x double> [ %.promoted6, %B46.endif.endif.lr.ph.split ], [ %111, %B46.endif.endif ]
  %54 = phi <8 x double> [ %.promoted5, %B46.endif.endif.lr.ph.split ], [ %110, %B46.endif.endif ]
  %55 = phi <8 x double> [ %.promoted4, %B46.endif.endif.lr.ph.split ], [ %99, %B46.endif.endif ]
  %56 = phi <8 x double> [ %.promoted3, %B46.endif.endif.lr.ph.split ], [ %98, %B46.endif.endif ]
  %57 = phi <8 x double> [ %.promoted2, %B46.endif.endif.lr.ph.split ], [ %87, %B46.endif.endif ]
  %58 = phi <8 x double> [ %.promoted1, %B46.endif.endif.lr.ph.split ], [ %86, %B46.endif.endif ]
  %59 = phi <8 x double> [ %.promoted, %B46.endif.endif.lr.ph.split ], [ %75, %B46.endif.endif ]
  %60 = phi <8 x double> [ %arg.total.4.promoted, %B46.endif.endif.lr.ph.split ], [ %74, %B46.endif.endif ]
  %.164280285 = phi i64 [ 0, %B46.endif.endif.lr.ph.split ], [ %.171, %B46.endif.endif ]
  %61 = shl i64 %.164280285, 3
  %scevgep52 = getelementptr i8, ptr %arg.ahead.4, i64 %61
  %.229 = load double, ptr %scevgep52, align 8
  %62 = shl i64 %.164280285, 3
  %scevgep51 = getelementptr i8, ptr %arg.fresh.4, i64 %62
  %.260 = load double, ptr %scevgep51, align 8
  %63 = shl i64 %.164280285, 3
  %scevgep50 = getelementptr i8, ptr %arg.stale.4, i64 %63
  %.291 = load double, ptr %scevgep50, align 8
  %scevgep48 = getelementptr i8, ptr %lsr.iv41, i64 -448
  %broadcast.splatinsert4 = insertelement <8 x double> poison, double %.291, i64 0
  %broadcast.splat5 = shufflevector <8 x double> %broadcast.splatinsert4, <8 x double> poison, <8 x i32> zeroinitializer
  %broadcast.splatinsert2 = insertelement <8 x double> poison, double %.260, i64 0
  %broadcast.splat3 = shufflevector <8 x double> %broadcast.splatinsert2, <8 x double> poison, <8 x i32> zeroinitializer
  %broadcast.splatinsert = insertelement <8 x double> poison, double %.229, i64 0
  %broadcast.splat = shufflevector <8 x double> %broadcast.splatinsert, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep49 = getelementptr i8, ptr %lsr.iv41, i64 -384
  %wide.load = load <8 x double>, ptr %scevgep48, align 8, !alias.scope !342, !noalias !339
  %wide.load6 = load <8 x double>, ptr %scevgep49, align 8, !alias.scope !342, !noalias !339
  %64 = fmul <8 x double> %wide.load7.pre, %broadcast.splat3
  %65 = fmul <8 x double> %wide.load8.pre, %broadcast.splat3
  %66 = fsub <8 x double> %wide.load, %64
  %67 = fsub <8 x double> %wide.load6, %65
  %68 = fmul <8 x double> %wide.load9.pre, %broadcast.splat5
  %69 = fmul <8 x double> %wide.load10.pre, %broadcast.splat5
  %70 = fsub <8 x double> %66, %68
  %71 = fsub <8 x double> %67, %69
  store <8 x double> %70, ptr %scevgep48, align 8, !alias.scope !342, !noalias !339
  store <8 x double> %71, ptr %scevgep49, align 8, !alias.scope !342, !noalias !339
  %72 = fmul <8 x double> %broadcast.splat, %70
  %73 = fmul <8 x double> %broadcast.splat, %71
  %74 = fadd <8 x double> %60, %72
  %75 = fadd <8 x double> %59, %73
  store <8 x double> %74, ptr %arg.total.4, align 8, !alias.scope !339
  %sunkaddr59 = getelementptr i8, ptr %arg.total.4, i64 64
  store <8 x double> %75, ptr %sunkaddr59, align 8, !alias.scope !339
  %scevgep47 = getelementptr i8, ptr %lsr.iv41, i64 -320
  %scevgep46 = getelementptr i8, ptr %lsr.iv41, i64 -256
  %wide.load.1 = load <8 x double>, ptr %scevgep47, align 8, !alias.scope !342, !noalias !339
  %wide.load6.1 = load <8 x double>, ptr %scevgep46, align 8, !alias.scope !342, !noalias !339
  %76 = fmul <8 x double> %wide.load7.1.pre, %broadcast.splat3
  %77 = fmul <8 x double> %wide.load8.1.pre, %broadcast.splat3
  %78 = fsub <8 x double> %wide.load.1, %76
  %79 = fsub <8 x double> %wide.load6.1, %77
  %80 = fmul <8 x double> %wide.load9.1.pre, %broadcast.splat5
  %81 = fmul <8 x double> %wide.load10.1.pre, %broadcast.splat5
  %82 = fsub <8 x double> %78, %80
  %83 = fsub <8 x double> %79, %81
  store <8 x double> %82, ptr %scevgep47, align 8, !alias.scope !342, !noalias !339
  store <8 x double> %83, ptr %scevgep46, align 8, !alias.scope !342, !noalias !339
  %84 = fmul <8 x double> %broadcast.splat, %82
  %85 = fmul <8 x double> %broadcast.splat, %83
  %86 = fadd <8 x double> %58, %84
  %87 = fadd <8 x double> %57, %85
  %sunkaddr60 = getelementptr i8, ptr %arg.total.4, i64 128
  store <8 x double> %86, ptr %sunkaddr60, align 8, !alias.scope !339
  %sunkaddr61 = getelementptr i8, ptr %arg.total.4, i64 192
  store <8 x double> %87, ptr %sunkaddr61, align 8, !alias.scope !339
  %scevgep45 = getelementptr i8, ptr %lsr.iv41, i64 -192
  %scevgep44 = getelementptr i8, ptr %lsr.iv41, i64 -128
  %wide.load.2 = load <8 x double>, ptr %scevgep45, align 8, !alias.scope !342, !noalias !339
  %wide.load6.2 = load <8 x double>, ptr %scevgep44, align 8, !alias.scope !342, !noalias !339
  %88 = fmul <8 x double> %wide.load7.2.pre, %broadcast.splat3
  %89 = fmul <8 x double> %wide.load8.2.pre, %broadcast.splat3
  %90 = fsub <8 x double> %wide.load.2, %88
  %91 = fsub <8 x double> %wide.load6.2, %89
  %92 = fmul <8 x double> %wide.load9.2.pre, %broadcast.splat5
  %93 = fmul <8 x double> %wide.load10.2.pre, %broadcast.splat5
  %94 = fsub <8 x double> %90, %92
  %95 = fsub <8 x double> %91, %93
  store <8 x double> %94, ptr %scevgep45, align 8, !alias.scope !342, !noalias !339
  store <8 x double> %95, ptr %scevgep44, align 8, !alias.scope !342, !noalias !339
  %96 = fmul <8 x double> %broadcast.splat, %94
  %97 = fmul <8 x double> %broadcast.splat, %95
  %98 = fadd <8 x double> %56, %96
  %99 = fadd <8 x double> %55, %97
  %sunkaddr62 = getelementptr i8, ptr %arg.total.4, i64 256
  store <8 x double> %98, ptr %sunkaddr62, align 8, !alias.scope !339
  %sunkaddr63 = getelementptr i8, ptr %arg.total.4, i64 320
  store <8 x double> %99, ptr %sunkaddr63, align 8, !alias.scope !339
  %scevgep43 = getelementptr i8, ptr %lsr.iv41, i64 -64
  %wide.load.3 = load <8 x double>, ptr %scevgep43, align 8, !alias.scope !342, !noalias !339
  %wide.load6.3 = load <8 x double>, ptr %lsr.iv41, align 8, !alias.scope !342, !noalias !339
  %100 = fmul <8 x double> %wide.load7.3.pre, %broadcast.splat3
  %101 = fmul <8 x double> %wide.load8.3.pre, %broadcast.splat3
  %102 = fsub <8 x double> %wide.load.3, %100
  %103 = fsub <8 x double> %wide.load6.3, %101
  %104 = fmul <8 x double> %wide.load9.3.pre, %broadcast.splat5
  %105 = fmul <8 x double> %wide.load10.3.pre, %broadcast.splat5
  %106 = fsub <8 x double> %102, %104
  %107 = fsub <8 x double> %103, %105
  store <8 x double> %106, ptr %scevgep43, align 8, !alias.scope !342, !noalias !339
  store <8 x double> %107, ptr %lsr.iv41, align 8, !alias.scope !342, !noalias !339
  %108 = fmul <8 x double> %broadcast.splat, %106
  %109 = fmul <8 x double> %broadcast.splat, %107
  %110 = fadd <8 x double> %54, %108
  %111 = fadd <8 x double> %53, %109
  %sunkaddr64 = getelementptr i8, ptr %arg.total.4, i64 384
  store <8 x double> %110, ptr %sunkaddr64, align 8, !alias.scope !339
  %sunkaddr65 = getelementptr i8, ptr %arg.total.4, i64 448
  store <8 x double> %111, ptr %sunkaddr65, align 8, !alias.scope !339
  %.171 = add nuw nsw i64 %.164280285, 1
  %scevgep42 = getelementptr i8, ptr %lsr.iv41, i64 %52
  %exitcond290.not = icmp eq i64 %arg.ahead.2, %.171
  br i1 %exitcond290.not, label %B306, label %B46.endif.endif
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(write)
declare void @llvm.masked.scatter.v8f64.v8p0(<8 x double>, <8 x ptr>, <8 x i1>) #13

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define linkonce_odr noundef i32 @_ZN18elastomer_friction7kernels8rheology6scaled5go_onB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29x(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.law.0.0, ptr readnone captures(none) %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr readonly captures(none) %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr readnone captures(none) %arg.law.1.0, ptr readnone captures(none) %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr readonly captures(none) %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr readnone captures(none) %arg.law.2.0, ptr readnone captures(none) %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr readonly captures(none) %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr readnone captures(none) %arg.scales.0.0, ptr readnone captures(none) %arg.scales.0.1, i64 %arg.scales.0.2, i64 %arg.scales.0.3, ptr writeonly captures(none) %arg.scales.0.4, i64 %arg.scales.0.5.0, i64 %arg.scales.0.6.0, ptr readnone captures(none) %arg.scales.1.0, ptr readnone captures(none) %arg.scales.1.1, i64 %arg.scales.1.2, i64 %arg.scales.1.3, ptr captures(none) %arg.scales.1.4, i64 %arg.scales.1.5.0, i64 %arg.scales.1.6.0, ptr readnone captures(none) %arg.scales.2.0, ptr readnone captures(none) %arg.scales.2.1, i64 %arg.scales.2.2, i64 %arg.scales.2.3, ptr writeonly captures(none) %arg.scales.2.4, i64 %arg.scales.2.5.0, i64 %arg.scales.2.6.0, ptr readnone captures(none) %arg.scales.3.0, ptr readnone captures(none) %arg.scales.3.1, i64 %arg.scales.3.2, i64 %arg.scales.3.3, ptr writeonly captures(none) %arg.scales.3.4, i64 %arg.scales.3.5.0, i64 %arg.scales.3.6.0, ptr readnone captures(none) %arg.scales.4.0, ptr readnone captures(none) %arg.scales.4.1, i64 %arg.scales.4.2, i64 %arg.scales.4.3, ptr writeonly captures(none) %arg.scales.4.4, i64 %arg.scales.4.5.0, i64 %arg.scales.4.6.0, ptr readnone captures(none) %arg.scales.5.0, ptr readnone captures(none) %arg.scales.5.1, i64 %arg.scales.5.2, i64 %arg.scales.5.3, ptr readonly captures(none) %arg.scales.5.4, i64 %arg.scales.5.5.0, i64 %arg.scales.5.6.0, i64 %arg.step) local_unnamed_addr #9 {
B0.endif:
  %.184503.not = icmp slt i64 %arg.law.0.2, 1
  br i1 %.184503.not, label %B398, label %B56.preheader

B56.preheader:                                    ; preds = %B0.endif
  %min.iters.check = icmp samesign ult i64 %arg.law.0.2, 64
  br i1 %min.iters.check, label %B56.preheader128, label %vector.memcheck

vector.memcheck:                                  ; preds = %B56.preheader
  %0 = shl i64 %arg.law.0.2, 3
  %scevgep = getelementptr i8, ptr %arg.scales.2.4, i64 %0
  %scevgep1 = getelementptr i8, ptr %arg.scales.1.4, i64 %0
  %scevgep2 = getelementptr i8, ptr %arg.scales.0.4, i64 %0
  %scevgep3 = getelementptr i8, ptr %arg.scales.3.4, i64 %0
  %scevgep4 = getelementptr i8, ptr %arg.scales.4.4, i64 %0
  %scevgep5 = getelementptr i8, ptr %arg.scales.5.4, i64 %0
  %scevgep6 = getelementptr i8, ptr %arg.law.0.4, i64 %0
  %scevgep7 = getelementptr i8, ptr %arg.law.1.4, i64 %0
  %scevgep8 = getelementptr i8, ptr %arg.law.2.4, i64 %0
  %bound0 = icmp ult ptr %arg.scales.2.4, %scevgep1
  %bound1 = icmp ult ptr %arg.scales.1.4, %scevgep
  %found.conflict = and i1 %bound0, %bound1
  %bound09 = icmp ult ptr %arg.scales.2.4, %scevgep2
  %bound110 = icmp ult ptr %arg.scales.0.4, %scevgep
  %found.conflict11 = and i1 %bound09, %bound110
  %conflict.rdx = or i1 %found.conflict, %found.conflict11
  %bound012 = icmp ult ptr %arg.scales.2.4, %scevgep3
  %bound113 = icmp ult ptr %arg.scales.3.4, %scevgep
  %found.conflict14 = and i1 %bound113, %bound012
  %conflict.rdx15 = or i1 %conflict.rdx, %found.conflict14
  %bound016 = icmp ult ptr %arg.scales.2.4, %scevgep4
  %bound117 = icmp ult ptr %arg.scales.4.4, %scevgep
  %found.conflict18 = and i1 %bound117, %bound016
  %conflict.rdx19 = or i1 %conflict.rdx15, %found.conflict18
  %bound020 = icmp ult ptr %arg.scales.2.4, %scevgep5
  %bound121 = icmp ult ptr %arg.scales.5.4, %scevgep
  %found.conflict22 = and i1 %bound121, %bound020
  %conflict.rdx23 = or i1 %conflict.rdx19, %found.conflict22
  %bound024 = icmp ult ptr %arg.scales.2.4, %scevgep6
  %bound125 = icmp ult ptr %arg.law.0.4, %scevgep
  %found.conflict26 = and i1 %bound024, %bound125
  %conflict.rdx27 = or i1 %found.conflict26, %conflict.rdx23
  %bound028 = icmp ult ptr %arg.scales.2.4, %scevgep7
  %bound129 = icmp ult ptr %arg.law.1.4, %scevgep
  %found.conflict30 = and i1 %bound028, %bound129
  %conflict.rdx31 = or i1 %found.conflict30, %conflict.rdx27
  %bound032 = icmp ult ptr %arg.scales.2.4, %scevgep8
  %bound133 = icmp ult ptr %arg.law.2.4, %scevgep
  %found.conflict34 = and i1 %bound032, %bound133
  %conflict.rdx35 = or i1 %found.conflict34, %conflict.rdx31
  %bound036 = icmp ult ptr %arg.scales.1.4, %scevgep2
  %bound137 = icmp ult ptr %arg.scales.0.4, %scevgep1
  %found.conflict38 = and i1 %bound036, %bound137
  %conflict.rdx39 = or i1 %found.conflict38, %conflict.rdx35
  %bound040 = icmp ult ptr %arg.scales.1.4, %scevgep3
  %bound141 = icmp ult ptr %arg.scales.3.4, %scevgep1
  %found.conflict42 = and i1 %bound141, %bound040
  %conflict.rdx43 = or i1 %found.conflict42, %conflict.rdx39
  %bound044 = icmp ult ptr %arg.scales.1.4, %scevgep4
  %bound145 = icmp ult ptr %arg.scales.4.4, %scevgep1
  %found.conflict46 = and i1 %bound145, %bound044
  %conflict.rdx47 = or i1 %found.conflict46, %conflict.rdx43
  %bound048 = icmp ult ptr %arg.scales.1.4, %scevgep5
  %bound149 = icmp ult ptr %arg.scales.5.4, %scevgep1
  %found.conflict50 = and i1 %bound149, %bound048
  %conflict.rdx51 = or i1 %found.conflict50, %conflict.rdx47
  %bound052 = icmp ult ptr %arg.scales.1.4, %scevgep6
  %bound153 = icmp ult ptr %arg.law.0.4, %scevgep1
  %found.conflict54 = and i1 %bound052, %bound153
  %conflict.rdx55 = or i1 %found.conflict54, %conflict.rdx51
  %bound056 = icmp ult ptr %arg.scales.1.4, %scevgep7
  %bound157 = icmp ult ptr %arg.law.1.4, %scevgep1
  %found.conflict58 = and i1 %bound056, %bound157
  %conflict.rdx59 = or i1 %found.conflict58, %conflict.rdx55
  %bound060 = icmp ult ptr %arg.scales.1.4, %scevgep8
  %bound161 = icmp ult ptr %arg.law.2.4, %scevgep1
  %found.conflict62 = and i1 %bound060, %bound161
  %conflict.rdx63 = or i1 %found.conflict62, %conflict.rdx59
  %bound064 = icmp ult ptr %arg.scales.0.4, %scevgep3
  %bound165 = icmp ult ptr %arg.scales.3.4, %scevgep2
  %found.conflict66 = and i1 %bound165, %bound064
  %conflict.rdx67 = or i1 %found.conflict66, %conflict.rdx63
  %bound068 = icmp ult ptr %arg.scales.0.4, %scevgep4
  %bound169 = icmp ult ptr %arg.scales.4.4, %scevgep2
  %found.conflict70 = and i1 %bound169, %bound068
  %conflict.rdx71 = or i1 %found.conflict70, %conflict.rdx67
  %bound072 = icmp ult ptr %arg.scales.0.4, %scevgep5
  %bound173 = icmp ult ptr %arg.scales.5.4, %scevgep2
  %found.conflict74 = and i1 %bound173, %bound072
  %conflict.rdx75 = or i1 %found.conflict74, %conflict.rdx71
  %bound076 = icmp ult ptr %arg.scales.0.4, %scevgep6
  %bound177 = icmp ult ptr %arg.law.0.4, %scevgep2
  %found.conflict78 = and i1 %bound076, %bound177
  %conflict.rdx79 = or i1 %found.conflict78, %conflict.rdx75
  %bound080 = icmp ult ptr %arg.scales.0.4, %scevgep7
  %bound181 = icmp ult ptr %arg.law.1.4, %scevgep2
  %found.conflict82 = and i1 %bound080, %bound181
  %conflict.rdx83 = or i1 %found.conflict82, %conflict.rdx79
  %bound084 = icmp ult ptr %arg.scales.0.4, %scevgep8
  %bound185 = icmp ult ptr %arg.law.2.4, %scevgep2
  %found.conflict86 = and i1 %bound084, %bound185
  %conflict.rdx87 = or i1 %found.conflict86, %conflict.rdx83
  %bound088 = icmp ult ptr %arg.scales.3.4, %scevgep4
  %bound189 = icmp ult ptr %arg.scales.4.4, %scevgep3
  %found.conflict90 = and i1 %bound189, %bound088
  %conflict.rdx91 = or i1 %found.conflict90, %conflict.rdx87
  %bound092 = icmp ult ptr %arg.scales.3.4, %scevgep5
  %bound193 = icmp ult ptr %arg.scales.5.4, %scevgep3
  %found.conflict94 = and i1 %bound193, %bound092
  %conflict.rdx95 = or i1 %found.conflict94, %conflict.rdx91
  %bound096 = icmp ult ptr %arg.scales.3.4, %scevgep6
  %bound197 = icmp ult ptr %arg.law.0.4, %scevgep3
  %found.conflict98 = and i1 %bound096, %bound197
  %conflict.rdx99 = or i1 %found.conflict98, %conflict.rdx95
  %bound0100 = icmp ult ptr %arg.scales.3.4, %scevgep7
  %bound1101 = icmp ult ptr %arg.law.1.4, %scevgep3
  %found.conflict102 = and i1 %bound0100, %bound1101
  %conflict.rdx103 = or i1 %found.conflict102, %conflict.rdx99
  %bound0104 = icmp ult ptr %arg.scales.3.4, %scevgep8
  %bound1105 = icmp ult ptr %arg.law.2.4, %scevgep3
  %found.conflict106 = and i1 %bound0104, %bound1105
  %conflict.rdx107 = or i1 %found.conflict106, %conflict.rdx103
  %bound0108 = icmp ult ptr %arg.scales.4.4, %scevgep5
  %bound1109 = icmp ult ptr %arg.scales.5.4, %scevgep4
  %found.conflict110 = and i1 %bound1109, %bound0108
  %conflict.rdx111 = or i1 %found.conflict110, %conflict.rdx107
  %bound0112 = icmp ult ptr %arg.scales.4.4, %scevgep6
  %bound1113 = icmp ult ptr %arg.law.0.4, %scevgep4
  %found.conflict114 = and i1 %bound0112, %bound1113
  %conflict.rdx115 = or i1 %found.conflict114, %conflict.rdx111
  %bound0116 = icmp ult ptr %arg.scales.4.4, %scevgep7
  %bound1117 = icmp ult ptr %arg.law.1.4, %scevgep4
  %found.conflict118 = and i1 %bound0116, %bound1117
  %conflict.rdx119 = or i1 %found.conflict118, %conflict.rdx115
  %bound0120 = icmp ult ptr %arg.scales.4.4, %scevgep8
  %bound1121 = icmp ult ptr %arg.law.2.4, %scevgep4
  %found.conflict122 = and i1 %bound0120, %bound1121
  %conflict.rdx123 = or i1 %found.conflict122, %conflict.rdx119
  br i1 %conflict.rdx123, label %B56.preheader128, label %vector.ph

vector.ph:                                        ; preds = %vector.memcheck
  %n.vec = and i64 %arg.law.0.2, 9223372036854775800
  %broadcast.splatinsert = insertelement <8 x i64> poison, i64 %arg.step, i64 0
  %broadcast.splat = shufflevector <8 x i64> %broadcast.splatinsert, <8 x i64> poison, <8 x i32> zeroinitializer
  br label %vector.body

vector.body:                                      ; preds = %vector.body, %vector.ph
  %index = phi i64 [ 0, %vector.ph ], [ %index.next, %vector.body ]
  %1 = shl i64 %index, 3
  %scevgep59 = getelementptr i8, ptr %arg.scales.5.4, i64 %1
  %wide.load = load <8 x double>, ptr %scevgep59, align 8, !alias.scope !344
  %2 = shl i64 %index, 3
  %scevgep58 = getelementptr i8, ptr %arg.law.0.4, i64 %2
  %wide.load124 = load <8 x double>, ptr %scevgep58, align 8, !alias.scope !347
  %3 = fcmp olt <8 x double> %wide.load124, splat (double 0x39B0000000000000)
  %4 = xor <8 x i1> %3, splat (i1 true)
  %5 = fcmp olt <8 x double> %wide.load, splat (double 0x1FF0000000000000)
  %6 = select <8 x i1> %4, <8 x i1> %5, <8 x i1> zeroinitializer
  %7 = fmul <8 x double> %wide.load, splat (double 0x5FF0000000000000)
  %8 = shl i64 %index, 3
  %scevgep57 = getelementptr i8, ptr %arg.scales.1.4, i64 %8
  %wide.masked.load = tail call <8 x i64> @llvm.masked.load.v8i64.p0(ptr align 8 %scevgep57, <8 x i1> %6, <8 x i64> poison), !alias.scope !349, !noalias !351
  %9 = shl i64 %index, 3
  %scevgep56 = getelementptr i8, ptr %arg.scales.2.4, i64 %9
  tail call void @llvm.masked.store.v8i64.p0(<8 x i64> %wide.masked.load, ptr align 8 %scevgep56, <8 x i1> %6), !alias.scope !357, !noalias !359
  tail call void @llvm.masked.store.v8i64.p0(<8 x i64> %broadcast.splat, ptr align 8 %scevgep57, <8 x i1> %6), !alias.scope !349, !noalias !351
  tail call void @llvm.masked.store.v8i64.p0(<8 x i64> %broadcast.splat, ptr align 8 %scevgep56, <8 x i1> %3), !alias.scope !357, !noalias !359
  tail call void @llvm.masked.store.v8i64.p0(<8 x i64> %broadcast.splat, ptr align 8 %scevgep57, <8 x i1> %3), !alias.scope !349, !noalias !351
  %predphi = select <8 x i1> %6, <8 x double> %7, <8 x double> %wide.load
  %predphi125 = select <8 x i1> %3, <8 x double> splat (double 1.000000e+00), <8 x double> %predphi
  %10 = shl i64 %index, 3
  %scevgep55 = getelementptr i8, ptr %arg.scales.0.4, i64 %10
  store <8 x double> %predphi125, ptr %scevgep55, align 8, !alias.scope !360, !noalias !361
  %11 = shl i64 %index, 3
  %scevgep54 = getelementptr i8, ptr %arg.law.1.4, i64 %11
  %wide.load126 = load <8 x double>, ptr %scevgep54, align 8, !alias.scope !362
  %12 = fdiv <8 x double> %wide.load126, %predphi125
  %13 = shl i64 %index, 3
  %scevgep53 = getelementptr i8, ptr %arg.scales.3.4, i64 %13
  store <8 x double> %12, ptr %scevgep53, align 8, !alias.scope !363, !noalias !364
  %14 = shl i64 %index, 3
  %scevgep52 = getelementptr i8, ptr %arg.law.2.4, i64 %14
  %wide.load127 = load <8 x double>, ptr %scevgep52, align 8, !alias.scope !365
  %15 = fdiv <8 x double> %wide.load127, %predphi125
  %16 = shl i64 %index, 3
  %scevgep51 = getelementptr i8, ptr %arg.scales.4.4, i64 %16
  store <8 x double> %15, ptr %scevgep51, align 8, !alias.scope !366, !noalias !367
  %index.next = add nuw nsw i64 %index, 8
  %17 = icmp eq i64 %n.vec, %index.next
  br i1 %17, label %middle.block, label %vector.body, !llvm.loop !368

middle.block:                                     ; preds = %vector.body
  %cmp.n = icmp eq i64 %arg.law.0.2, %n.vec
  br i1 %cmp.n, label %B398, label %B56.preheader128

B56.preheader128:                                 ; preds = %middle.block, %vector.memcheck, %B56.preheader
  %.190502504.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %B56.preheader ], [ %n.vec, %middle.block ]
  %.neg = or disjoint i64 %.190502504.ph, 1
  %xtraiter = and i64 %arg.law.0.2, 1
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B56.prol.loopexit, label %B56.prol

B56.prol:                                         ; preds = %B56.preheader128
  %18 = getelementptr double, ptr %arg.scales.5.4, i64 %.190502504.ph
  %.256.prol = load double, ptr %18, align 8
  %19 = getelementptr double, ptr %arg.law.0.4, i64 %.190502504.ph
  %.291.prol = load double, ptr %19, align 8
  %.292.prol = fcmp olt double %.291.prol, 0x39B0000000000000
  br i1 %.292.prol, label %B128.prol, label %B174.prol

B174.prol:                                        ; preds = %B56.prol
  %.370.prol = fcmp olt double %.256.prol, 0x1FF0000000000000
  br i1 %.370.prol, label %B196.endif.prol, label %B280.prol

B196.endif.prol:                                  ; preds = %B174.prol
  %.376.prol = fmul double %.256.prol, 0x5FF0000000000000
  %20 = getelementptr i64, ptr %arg.scales.1.4, i64 %.190502504.ph
  %.412.prol = load i64, ptr %20, align 8
  %21 = getelementptr i64, ptr %arg.scales.2.4, i64 %.190502504.ph
  store i64 %.412.prol, ptr %21, align 8
  store i64 %arg.step, ptr %20, align 8
  br label %B280.prol

B128.prol:                                        ; preds = %B56.prol
  %22 = getelementptr i64, ptr %arg.scales.2.4, i64 %.190502504.ph
  store i64 %arg.step, ptr %22, align 8
  %23 = getelementptr i64, ptr %arg.scales.1.4, i64 %.190502504.ph
  store i64 %arg.step, ptr %23, align 8
  br label %B280.prol

B280.prol:                                        ; preds = %B128.prol, %B196.endif.prol, %B174.prol
  %scale.3.1.prol = phi double [ 1.000000e+00, %B128.prol ], [ %.376.prol, %B196.endif.prol ], [ %.256.prol, %B174.prol ]
  %24 = getelementptr double, ptr %arg.scales.0.4, i64 %.190502504.ph
  store double %scale.3.1.prol, ptr %24, align 8
  %25 = getelementptr double, ptr %arg.law.1.4, i64 %.190502504.ph
  %.545.prol = load double, ptr %25, align 8
  %.550.prol = fdiv double %.545.prol, %scale.3.1.prol
  %26 = getelementptr double, ptr %arg.scales.3.4, i64 %.190502504.ph
  store double %.550.prol, ptr %26, align 8
  %27 = getelementptr double, ptr %arg.law.2.4, i64 %.190502504.ph
  %.614.prol = load double, ptr %27, align 8
  %.619.prol = fdiv double %.614.prol, %scale.3.1.prol
  %28 = getelementptr double, ptr %arg.scales.4.4, i64 %.190502504.ph
  store double %.619.prol, ptr %28, align 8
  br label %B56.prol.loopexit

B56.prol.loopexit:                                ; preds = %B280.prol, %B56.preheader128
  %.190502504.unr = phi i64 [ %.190502504.ph, %B56.preheader128 ], [ %.neg, %B280.prol ]
  %29 = icmp eq i64 %arg.law.0.2, %.neg
  br i1 %29, label %B398, label %B56.preheader8

B56.preheader8:                                   ; preds = %B56.prol.loopexit
  %30 = shl i64 %.190502504.unr, 3
  %31 = add i64 %30, 8
  %scevgep9 = getelementptr i8, ptr %arg.scales.2.4, i64 %31
  %scevgep16 = getelementptr i8, ptr %arg.scales.1.4, i64 %31
  %32 = sub i64 %arg.law.0.2, %.190502504.unr
  %scevgep23 = getelementptr i8, ptr %arg.scales.4.4, i64 %31
  %scevgep27 = getelementptr i8, ptr %arg.law.2.4, i64 %31
  %scevgep31 = getelementptr i8, ptr %arg.scales.3.4, i64 %31
  %scevgep35 = getelementptr i8, ptr %arg.law.1.4, i64 %31
  %scevgep39 = getelementptr i8, ptr %arg.scales.0.4, i64 %31
  %scevgep43 = getelementptr i8, ptr %arg.law.0.4, i64 %31
  %scevgep47 = getelementptr i8, ptr %arg.scales.5.4, i64 %31
  br label %B56

B56:                                              ; preds = %B56.preheader8, %B280.1
  %lsr.iv = phi i64 [ 0, %B56.preheader8 ], [ %lsr.iv.next, %B280.1 ]
  %33 = shl i64 %lsr.iv, 3
  %scevgep48 = getelementptr i8, ptr %scevgep47, i64 %33
  %scevgep49 = getelementptr i8, ptr %scevgep48, i64 -8
  %.256 = load double, ptr %scevgep49, align 8
  %34 = shl i64 %lsr.iv, 3
  %scevgep44 = getelementptr i8, ptr %scevgep43, i64 %34
  %scevgep45 = getelementptr i8, ptr %scevgep44, i64 -8
  %.291 = load double, ptr %scevgep45, align 8
  %.292 = fcmp olt double %.291, 0x39B0000000000000
  br i1 %.292, label %B128, label %B174

B128:                                             ; preds = %B56
  %35 = shl i64 %lsr.iv, 3
  %scevgep12 = getelementptr i8, ptr %scevgep9, i64 %35
  %scevgep13 = getelementptr i8, ptr %scevgep12, i64 -8
  store i64 %arg.step, ptr %scevgep13, align 8
  %scevgep19 = getelementptr i8, ptr %scevgep16, i64 %35
  %scevgep20 = getelementptr i8, ptr %scevgep19, i64 -8
  store i64 %arg.step, ptr %scevgep20, align 8
  br label %B280

B174:                                             ; preds = %B56
  %.370 = fcmp olt double %.256, 0x1FF0000000000000
  br i1 %.370, label %B196.endif, label %B280

B280:                                             ; preds = %B196.endif, %B174, %B128
  %scale.3.1 = phi double [ 1.000000e+00, %B128 ], [ %.376, %B196.endif ], [ %.256, %B174 ]
  %36 = shl i64 %lsr.iv, 3
  %scevgep40 = getelementptr i8, ptr %scevgep39, i64 %36
  %scevgep41 = getelementptr i8, ptr %scevgep40, i64 -8
  store double %scale.3.1, ptr %scevgep41, align 8
  %37 = shl i64 %lsr.iv, 3
  %scevgep36 = getelementptr i8, ptr %scevgep35, i64 %37
  %scevgep37 = getelementptr i8, ptr %scevgep36, i64 -8
  %.545 = load double, ptr %scevgep37, align 8
  %.550 = fdiv double %.545, %scale.3.1
  %38 = shl i64 %lsr.iv, 3
  %scevgep32 = getelementptr i8, ptr %scevgep31, i64 %38
  %scevgep33 = getelementptr i8, ptr %scevgep32, i64 -8
  store double %.550, ptr %scevgep33, align 8
  %39 = shl i64 %lsr.iv, 3
  %scevgep28 = getelementptr i8, ptr %scevgep27, i64 %39
  %scevgep29 = getelementptr i8, ptr %scevgep28, i64 -8
  %.614 = load double, ptr %scevgep29, align 8
  %.619 = fdiv double %.614, %scale.3.1
  %40 = shl i64 %lsr.iv, 3
  %scevgep24 = getelementptr i8, ptr %scevgep23, i64 %40
  %scevgep25 = getelementptr i8, ptr %scevgep24, i64 -8
  store double %.619, ptr %scevgep25, align 8
  %scevgep50 = getelementptr i8, ptr %scevgep47, i64 %40
  %.256.1 = load double, ptr %scevgep50, align 8
  %41 = shl i64 %lsr.iv, 3
  %scevgep46 = getelementptr i8, ptr %scevgep43, i64 %41
  %.291.1 = load double, ptr %scevgep46, align 8
  %.292.1 = fcmp olt double %.291.1, 0x39B0000000000000
  br i1 %.292.1, label %B128.1, label %B174.1

B174.1:                                           ; preds = %B280
  %.370.1 = fcmp olt double %.256.1, 0x1FF0000000000000
  br i1 %.370.1, label %B196.endif.1, label %B280.1

B196.endif.1:                                     ; preds = %B174.1
  %.376.1 = fmul double %.256.1, 0x5FF0000000000000
  %42 = shl i64 %lsr.iv, 3
  %scevgep22 = getelementptr i8, ptr %scevgep16, i64 %42
  %.412.1 = load i64, ptr %scevgep22, align 8
  %43 = shl i64 %lsr.iv, 3
  %scevgep15 = getelementptr i8, ptr %scevgep9, i64 %43
  store i64 %.412.1, ptr %scevgep15, align 8
  store i64 %arg.step, ptr %scevgep22, align 8
  br label %B280.1

B128.1:                                           ; preds = %B280
  %44 = shl i64 %lsr.iv, 3
  %scevgep14 = getelementptr i8, ptr %scevgep9, i64 %44
  store i64 %arg.step, ptr %scevgep14, align 8
  %scevgep21 = getelementptr i8, ptr %scevgep16, i64 %44
  store i64 %arg.step, ptr %scevgep21, align 8
  br label %B280.1

B280.1:                                           ; preds = %B128.1, %B196.endif.1, %B174.1
  %scale.3.1.1 = phi double [ 1.000000e+00, %B128.1 ], [ %.376.1, %B196.endif.1 ], [ %.256.1, %B174.1 ]
  %45 = shl i64 %lsr.iv, 3
  %scevgep42 = getelementptr i8, ptr %scevgep39, i64 %45
  store double %scale.3.1.1, ptr %scevgep42, align 8
  %46 = shl i64 %lsr.iv, 3
  %scevgep38 = getelementptr i8, ptr %scevgep35, i64 %46
  %.545.1 = load double, ptr %scevgep38, align 8
  %.550.1 = fdiv double %.545.1, %scale.3.1.1
  %47 = shl i64 %lsr.iv, 3
  %scevgep34 = getelementptr i8, ptr %scevgep31, i64 %47
  store double %.550.1, ptr %scevgep34, align 8
  %48 = shl i64 %lsr.iv, 3
  %scevgep30 = getelementptr i8, ptr %scevgep27, i64 %48
  %.614.1 = load double, ptr %scevgep30, align 8
  %.619.1 = fdiv double %.614.1, %scale.3.1.1
  %49 = shl i64 %lsr.iv, 3
  %scevgep26 = getelementptr i8, ptr %scevgep23, i64 %49
  store double %.619.1, ptr %scevgep26, align 8
  %lsr.iv.next = add i64 %lsr.iv, 2
  %exitcond.not.1 = icmp eq i64 %32, %lsr.iv.next
  br i1 %exitcond.not.1, label %B398, label %B56, !llvm.loop !369

B398:                                             ; preds = %B280.1, %B56.prol.loopexit, %middle.block, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B196.endif:                                       ; preds = %B174
  %.376 = fmul double %.256, 0x5FF0000000000000
  %50 = shl i64 %lsr.iv, 3
  %scevgep17 = getelementptr i8, ptr %scevgep16, i64 %50
  %scevgep18 = getelementptr i8, ptr %scevgep17, i64 -8
  %.412 = load i64, ptr %scevgep18, align 8
  %51 = shl i64 %lsr.iv, 3
  %scevgep10 = getelementptr i8, ptr %scevgep9, i64 %51
  %scevgep11 = getelementptr i8, ptr %scevgep10, i64 -8
  store i64 %.412, ptr %scevgep11, align 8
  store i64 %arg.step, ptr %scevgep18, align 8
  br label %B280
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: read)
declare <8 x i64> @llvm.masked.load.v8i64.p0(ptr captures(none), <8 x i1>, <8 x i64>) #14

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: write)
declare void @llvm.masked.store.v8i64.p0(<8 x i64>, ptr captures(none), <8 x i1>) #15

define linkonce_odr range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels5scene12march_blocks5_keepB3v60B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEx102Retardation_28float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29xdd368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29vv(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, i64 %arg.k, double %arg.form.0, ptr readnone captures(none) %arg.form.1.0, ptr readnone captures(none) %arg.form.1.1, i64 %arg.form.1.2, i64 %arg.form.1.3, ptr readnone captures(none) %arg.form.1.4, i64 %arg.form.1.5.0, i64 %arg.form.1.6.0, ptr readnone captures(none) %arg.form.2.0, ptr readnone captures(none) %arg.form.2.1, i64 %arg.form.2.2, i64 %arg.form.2.3, ptr readnone captures(none) %arg.form.2.4, i64 %arg.form.2.5.0, i64 %arg.form.2.6.0, ptr %arg.law.0.0, ptr readnone captures(none) %arg.law.0.1, i64 %arg.law.0.2, i64 %arg.law.0.3, ptr readnone captures(none) %arg.law.0.4, i64 %arg.law.0.5.0, i64 %arg.law.0.6.0, ptr %arg.law.1.0, ptr readnone captures(none) %arg.law.1.1, i64 %arg.law.1.2, i64 %arg.law.1.3, ptr readnone captures(none) %arg.law.1.4, i64 %arg.law.1.5.0, i64 %arg.law.1.6.0, ptr %arg.law.2.0, ptr readnone captures(none) %arg.law.2.1, i64 %arg.law.2.2, i64 %arg.law.2.3, ptr readnone captures(none) %arg.law.2.4, i64 %arg.law.2.5.0, i64 %arg.law.2.6.0, double %arg.law.3, double %arg.law.4, double %arg.law.5, ptr %arg.track.0.0, ptr readnone captures(none) %arg.track.0.1, i64 %arg.track.0.2, i64 %arg.track.0.3, ptr readnone captures(none) %arg.track.0.4, i64 %arg.track.0.5.0, i64 %arg.track.0.5.1, i64 %arg.track.0.6.0, i64 %arg.track.0.6.1, ptr %arg.track.1.0, ptr readnone captures(none) %arg.track.1.1, i64 %arg.track.1.2, i64 %arg.track.1.3, ptr readonly captures(none) %arg.track.1.4, i64 %arg.track.1.5.0, i64 %arg.track.1.5.1, i64 %arg.track.1.6.0, i64 %arg.track.1.6.1, ptr %arg.track.2.0, ptr readnone captures(none) %arg.track.2.1, i64 %arg.track.2.2, i64 %arg.track.2.3, ptr readonly captures(none) %arg.track.2.4, i64 %arg.track.2.5.0, i64 %arg.track.2.6.0, ptr %arg.track.3.0, ptr readnone captures(none) %arg.track.3.1, i64 %arg.track.3.2, i64 %arg.track.3.3, ptr readonly captures(none) %arg.track.3.4, i64 %arg.track.3.5.0, i64 %arg.track.3.6.0, ptr %arg.track.4.0, ptr readnone captures(none) %arg.track.4.1, i64 %arg.track.4.2, i64 %arg.track.4.3, ptr readonly captures(none) %arg.track.4.4, i64 %arg.track.4.5.0, i64 %arg.track.4.6.0, ptr %arg.track.5.0, ptr readnone captures(none) %arg.track.5.1, i64 %arg.track.5.2, i64 %arg.track.5.3, ptr readonly captures(none) %arg.track.5.4, i64 %arg.track.5.5.0, i64 %arg.track.5.6.0, ptr %arg.track.6.0, ptr readnone captures(none) %arg.track.6.1, i64 %arg.track.6.2, i64 %arg.track.6.3, ptr readonly captures(none) %arg.track.6.4, i64 %arg.track.6.5.0, i64 %arg.track.6.6.0, i64 %arg.s, double %arg.old, double %arg.d, ptr readnone captures(none) %arg.blocks.0.0, ptr readnone captures(none) %arg.blocks.0.1, i64 %arg.blocks.0.2, i64 %arg.blocks.0.3, ptr readnone captures(none) %arg.blocks.0.4, i64 %arg.blocks.0.5.0, i64 %arg.blocks.0.5.1, i64 %arg.blocks.0.5.2, i64 %arg.blocks.0.6.0, i64 %arg.blocks.0.6.1, i64 %arg.blocks.0.6.2, ptr readnone captures(none) %arg.blocks.1.0, ptr readnone captures(none) %arg.blocks.1.1, i64 %arg.blocks.1.2, i64 %arg.blocks.1.3, ptr readnone captures(none) %arg.blocks.1.4, i64 %arg.blocks.1.5.0, i64 %arg.blocks.1.6.0, ptr readnone captures(none) %arg.blocks.2.0, ptr readnone captures(none) %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr readnone captures(none) %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0, ptr readnone captures(none) %arg.blocks.3.0.0, ptr readnone captures(none) %arg.blocks.3.0.1, i64 %arg.blocks.3.0.2, i64 %arg.blocks.3.0.3, ptr readnone captures(none) %arg.blocks.3.0.4, i64 %arg.blocks.3.0.5.0, i64 %arg.blocks.3.0.6.0, ptr readnone captures(none) %arg.blocks.3.1.0, ptr readnone captures(none) %arg.blocks.3.1.1, i64 %arg.blocks.3.1.2, i64 %arg.blocks.3.1.3, ptr readnone captures(none) %arg.blocks.3.1.4, i64 %arg.blocks.3.1.5.0, i64 %arg.blocks.3.1.6.0, ptr readnone captures(none) %arg.blocks.3.2.0, ptr readnone captures(none) %arg.blocks.3.2.1, i64 %arg.blocks.3.2.2, i64 %arg.blocks.3.2.3, ptr readnone captures(none) %arg.blocks.3.2.4, i64 %arg.blocks.3.2.5.0, i64 %arg.blocks.3.2.6.0, ptr readnone captures(none) %arg.blocks.3.3.0, ptr readnone captures(none) %arg.blocks.3.3.1, i64 %arg.blocks.3.3.2, i64 %arg.blocks.3.3.3, ptr readnone captures(none) %arg.blocks.3.3.4, i64 %arg.blocks.3.3.5.0, i64 %arg.blocks.3.3.6.0, ptr readnone captures(none) %arg.blocks.3.4.0, ptr readnone captures(none) %arg.blocks.3.4.1, i64 %arg.blocks.3.4.2, i64 %arg.blocks.3.4.3, ptr readnone captures(none) %arg.blocks.3.4.4, i64 %arg.blocks.3.4.5.0, i64 %arg.blocks.3.4.6.0, ptr readnone captures(none) %arg.blocks.3.5.0, ptr readnone captures(none) %arg.blocks.3.5.1, i64 %arg.blocks.3.5.2, i64 %arg.blocks.3.5.3, ptr readnone captures(none) %arg.blocks.3.5.4, i64 %arg.blocks.3.5.5.0, i64 %arg.blocks.3.5.6.0, ptr %arg.some.0, ptr readnone captures(none) %arg.some.1, i64 %arg.some.2, i64 %arg.some.3, ptr readonly captures(none) %arg.some.4, i64 %arg.some.5.0, i64 %arg.some.6.0, ptr %arg.p.0, ptr readnone captures(none) %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr readonly captures(none) %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1, ptr %arg.trace.0.0, ptr readnone captures(none) %arg.trace.0.1, i64 %arg.trace.0.2, i64 %arg.trace.0.3, ptr writeonly captures(none) %arg.trace.0.4, i64 %arg.trace.0.5.0, i64 %arg.trace.0.6.0, ptr %arg.trace.1.0, ptr readnone captures(none) %arg.trace.1.1, i64 %arg.trace.1.2, i64 %arg.trace.1.3, ptr writeonly captures(none) %arg.trace.1.4, i64 %arg.trace.1.5.0, i64 %arg.trace.1.6.0, ptr %arg.trace.2.0, ptr readnone captures(none) %arg.trace.2.1, i64 %arg.trace.2.2, i64 %arg.trace.2.3, ptr writeonly captures(none) %arg.trace.2.4, i64 %arg.trace.2.5.0, i64 %arg.trace.2.6.0, ptr %arg.trace.3.0, ptr readnone captures(none) %arg.trace.3.1, i64 %arg.trace.3.2, i64 %arg.trace.3.3, ptr writeonly captures(none) %arg.trace.3.4, i64 %arg.trace.3.5.0, i64 %arg.trace.3.6.0, ptr %arg.trace.4.0, ptr readnone captures(none) %arg.trace.4.1, i64 %arg.trace.4.2, i64 %arg.trace.4.3, ptr writeonly captures(none) %arg.trace.4.4, i64 %arg.trace.4.5.0, i64 %arg.trace.4.6.0, ptr %arg.trace.5.0, ptr readnone captures(none) %arg.trace.5.1, i64 %arg.trace.5.2, i64 %arg.trace.5.3, ptr writeonly captures(none) %arg.trace.5.4, i64 %arg.trace.5.5.0, i64 %arg.trace.5.6.0, ptr %arg.trace.6.0, ptr readnone captures(none) %arg.trace.6.1, i64 %arg.trace.6.2, i64 %arg.trace.6.3, ptr writeonly captures(none) %arg.trace.6.4, i64 %arg.trace.6.5.0, i64 %arg.trace.6.6.0, ptr %arg.trace.7.0, ptr readnone captures(none) %arg.trace.7.1, i64 %arg.trace.7.2, i64 %arg.trace.7.3, ptr writeonly captures(none) %arg.trace.7.4, i64 %arg.trace.7.5.0, i64 %arg.trace.7.6.0, ptr readnone captures(none) %arg.ledger, ptr readnone captures(none) %arg.lengths) local_unnamed_addr {
B0.else.if:
  %.569 = alloca [3 x double], align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  tail call void @NRT_incref(ptr %arg.law.0.0)
  tail call void @NRT_incref(ptr %arg.law.1.0)
  tail call void @NRT_incref(ptr %arg.law.2.0)
  tail call void @NRT_incref(ptr %arg.track.0.0)
  tail call void @NRT_incref(ptr %arg.track.1.0)
  tail call void @NRT_incref(ptr %arg.track.2.0)
  tail call void @NRT_incref(ptr %arg.track.3.0)
  tail call void @NRT_incref(ptr %arg.track.4.0)
  tail call void @NRT_incref(ptr %arg.track.5.0)
  tail call void @NRT_incref(ptr %arg.track.6.0)
  tail call void @NRT_incref(ptr %arg.some.0)
  tail call void @NRT_incref(ptr %arg.p.0)
  tail call void @NRT_incref(ptr %arg.trace.0.0)
  tail call void @NRT_incref(ptr %arg.trace.1.0)
  tail call void @NRT_incref(ptr %arg.trace.2.0)
  tail call void @NRT_incref(ptr %arg.trace.3.0)
  tail call void @NRT_incref(ptr %arg.trace.4.0)
  tail call void @NRT_incref(ptr %arg.trace.5.0)
  tail call void @NRT_incref(ptr %arg.trace.6.0)
  tail call void @NRT_incref(ptr %arg.trace.7.0)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.569, i8 0, i64 24, i1 false)
  %.597 = call i32 @_ZN18elastomer_friction7kernels5scene12march_blocks5_sumsB3v61B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29x5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE(ptr nonnull %.569, ptr nonnull %excinfo.1, double %arg.law.4, ptr %arg.track.0.0, ptr %arg.track.0.1, i64 %arg.track.0.2, i64 %arg.track.0.3, ptr %arg.track.0.4, i64 %arg.track.0.5.0, i64 %arg.track.0.5.1, i64 %arg.track.0.6.0, i64 %arg.track.0.6.1, ptr %arg.track.1.0, ptr %arg.track.1.1, i64 %arg.track.1.2, i64 %arg.track.1.3, ptr %arg.track.1.4, i64 %arg.track.1.5.0, i64 %arg.track.1.5.1, i64 %arg.track.1.6.0, i64 %arg.track.1.6.1, ptr %arg.track.2.0, ptr %arg.track.2.1, i64 %arg.track.2.2, i64 %arg.track.2.3, ptr %arg.track.2.4, i64 %arg.track.2.5.0, i64 %arg.track.2.6.0, ptr %arg.track.3.0, ptr %arg.track.3.1, i64 %arg.track.3.2, i64 %arg.track.3.3, ptr %arg.track.3.4, i64 %arg.track.3.5.0, i64 %arg.track.3.6.0, ptr %arg.track.4.0, ptr %arg.track.4.1, i64 %arg.track.4.2, i64 %arg.track.4.3, ptr %arg.track.4.4, i64 %arg.track.4.5.0, i64 %arg.track.4.6.0, ptr %arg.track.5.0, ptr %arg.track.5.1, i64 %arg.track.5.2, i64 %arg.track.5.3, ptr %arg.track.5.4, i64 %arg.track.5.5.0, i64 %arg.track.5.6.0, ptr %arg.track.6.0, ptr %arg.track.6.1, i64 %arg.track.6.2, i64 %arg.track.6.3, ptr %arg.track.6.4, i64 %arg.track.6.5.0, i64 %arg.track.6.6.0, i64 %arg.s, ptr %arg.some.0, ptr %arg.some.1, i64 %arg.some.2, i64 %arg.some.3, ptr %arg.some.4, i64 %arg.some.5.0, i64 %arg.some.6.0, ptr %arg.p.0, ptr %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1)
  %cond = icmp eq i32 %.597, 0
  br i1 %cond, label %B412, label %B50.if.if, !prof !0

common.ret:                                       ; preds = %B50.if.if, %select.end
  ret i32 %.597

B412:                                             ; preds = %B0.else.if
  %.fca.2.gep = getelementptr inbounds nuw i8, ptr %.569, i64 16
  %.fca.1.gep = getelementptr inbounds nuw i8, ptr %.569, i64 8
  %.607.fca.2.load = load double, ptr %.fca.2.gep, align 8
  %.607.fca.1.load = load double, ptr %.fca.1.gep, align 8
  %.607.fca.0.load = load double, ptr %.569, align 8
  %.520.1 = ashr i64 %arg.track.0.5.1, 1
  tail call void @NRT_decref(ptr %arg.some.0)
  tail call void @NRT_decref(ptr %arg.p.0)
  %"$phi60.0.2.0.i.frozen" = freeze double %.607.fca.0.load
  %.164.i = fcmp ogt double %"$phi60.0.2.0.i.frozen", 0.000000e+00
  br i1 %.164.i, label %select.true.sink, label %select.end

select.true.sink:                                 ; preds = %B412
  %.171.i = fdiv double %.607.fca.1.load, %.607.fca.0.load
  br label %select.end

select.end:                                       ; preds = %B412, %select.true.sink
  %"$phi60.0.2.0.i" = phi double [ %.171.i, %select.true.sink ], [ 0x7FF8000000000000, %B412 ]
  %.198.i = icmp slt i64 %arg.k, 0
  %.199.i = select i1 %.198.i, i64 %arg.trace.0.5.0, i64 0
  %0 = getelementptr double, ptr %arg.trace.0.4, i64 %arg.k
  %.213.i = getelementptr double, ptr %0, i64 %.199.i
  store double %"$phi60.0.2.0.i", ptr %.213.i, align 8, !noalias !370
  %.222.i = fsub double %arg.old, %arg.d
  %.226.i = fmul double %arg.law.4, %.222.i
  %.230.i = fadd double %arg.d, %.226.i
  %.252.i = select i1 %.198.i, i64 %arg.trace.1.5.0, i64 0
  %1 = getelementptr double, ptr %arg.trace.1.4, i64 %arg.k
  %.266.i = getelementptr double, ptr %1, i64 %.252.i
  store double %.230.i, ptr %.266.i, align 8, !noalias !370
  %.273.i = sitofp i64 %.520.1 to double
  %.277.i = fdiv double %.607.fca.0.load, %.273.i
  %.299.i = select i1 %.198.i, i64 %arg.trace.2.5.0, i64 0
  %2 = getelementptr double, ptr %arg.trace.2.4, i64 %arg.k
  %.313.i = getelementptr double, ptr %2, i64 %.299.i
  store double %.277.i, ptr %.313.i, align 8, !noalias !370
  %.324.i = fdiv double %.607.fca.1.load, %.273.i
  %.346.i = select i1 %.198.i, i64 %arg.trace.3.5.0, i64 0
  %3 = getelementptr double, ptr %arg.trace.3.4, i64 %arg.k
  %.360.i = getelementptr double, ptr %3, i64 %.346.i
  store double %.324.i, ptr %.360.i, align 8, !noalias !370
  %.371.i = fdiv double %.607.fca.2.load, %.273.i
  %.429.i = select i1 %.198.i, i64 %arg.trace.4.5.0, i64 0
  %4 = getelementptr double, ptr %arg.trace.4.4, i64 %arg.k
  %.443.i = getelementptr double, ptr %4, i64 %.429.i
  store double %.371.i, ptr %.443.i, align 8, !noalias !370
  tail call void @NRT_decref(ptr %arg.law.0.0)
  tail call void @NRT_decref(ptr %arg.law.1.0)
  tail call void @NRT_decref(ptr %arg.law.2.0)
  %.219.i = add nsw i64 %arg.s, 1
  %.232.i = icmp slt i64 %arg.s, -1
  %.233.i = select i1 %.232.i, i64 %arg.track.5.5.0, i64 0
  %5 = getelementptr double, ptr %arg.track.5.4, i64 %.219.i
  %.247.i = getelementptr double, ptr %5, i64 %.233.i
  %.248.i = load double, ptr %.247.i, align 8, !noalias !373
  %.268.i = icmp slt i64 %arg.s, 0
  %.269.i = select i1 %.268.i, i64 %arg.track.5.5.0, i64 0
  %6 = getelementptr double, ptr %arg.track.5.4, i64 %arg.s
  %.283.i = getelementptr double, ptr %6, i64 %.269.i
  %.284.i = load double, ptr %.283.i, align 8, !noalias !373
  %.288.i = fsub double %.248.i, %.284.i
  %.307.i = select i1 %.232.i, i64 %arg.track.6.5.0, i64 0
  %7 = getelementptr double, ptr %arg.track.6.4, i64 %.219.i
  %.321.i = getelementptr double, ptr %7, i64 %.307.i
  %.322.i = load double, ptr %.321.i, align 8, !noalias !373
  %.343.i = select i1 %.268.i, i64 %arg.track.4.5.0, i64 0
  %8 = getelementptr double, ptr %arg.track.4.4, i64 %arg.s
  %.357.i = getelementptr double, ptr %8, i64 %.343.i
  %.358.i = load double, ptr %.357.i, align 8, !noalias !373
  %.362.i = fmul double %arg.law.4, %.358.i
  %.363.i = fsub double %.322.i, %.362.i
  %.381.i = select i1 %.198.i, i64 %arg.trace.5.5.0, i64 0
  %9 = getelementptr double, ptr %arg.trace.5.4, i64 %arg.k
  %.395.i = getelementptr double, ptr %9, i64 %.381.i
  store double %.363.i, ptr %.395.i, align 8, !noalias !373
  %.433.i = load double, ptr %.247.i, align 8, !noalias !373
  %.437.i = fmul double %arg.law.4, %.288.i
  %.438.i = fsub double %.433.i, %.437.i
  %.456.i = select i1 %.198.i, i64 %arg.trace.6.5.0, i64 0
  %10 = getelementptr double, ptr %arg.trace.6.4, i64 %arg.k
  %.470.i = getelementptr double, ptr %10, i64 %.456.i
  store double %.438.i, ptr %.470.i, align 8, !noalias !373
  %.532.i = load double, ptr %.357.i, align 8, !noalias !373
  %.539.i = fdiv double %.288.i, %.532.i
  %.589.i = select i1 %.198.i, i64 %arg.trace.7.5.0, i64 0
  %11 = getelementptr double, ptr %arg.trace.7.4, i64 %arg.k
  %.603.i = getelementptr double, ptr %11, i64 %.589.i
  store double %.539.i, ptr %.603.i, align 8, !noalias !373
  tail call void @NRT_decref(ptr %arg.track.0.0)
  tail call void @NRT_decref(ptr %arg.track.1.0)
  tail call void @NRT_decref(ptr %arg.track.2.0)
  tail call void @NRT_decref(ptr %arg.track.3.0)
  tail call void @NRT_decref(ptr %arg.track.4.0)
  tail call void @NRT_decref(ptr %arg.track.5.0)
  tail call void @NRT_decref(ptr %arg.track.6.0)
  tail call void @NRT_decref(ptr %arg.trace.0.0)
  tail call void @NRT_decref(ptr %arg.trace.1.0)
  tail call void @NRT_decref(ptr %arg.trace.2.0)
  tail call void @NRT_decref(ptr %arg.trace.3.0)
  tail call void @NRT_decref(ptr %arg.trace.4.0)
  tail call void @NRT_decref(ptr %arg.trace.5.0)
  tail call void @NRT_decref(ptr %arg.trace.6.0)
  tail call void @NRT_decref(ptr %arg.trace.7.0)
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B50.if.if:                                        ; preds = %B0.else.if
  %.605 = icmp sgt i32 %.597, 0
  %.598 = load ptr, ptr %excinfo.1, align 8
  %.606 = select i1 %.605, ptr %.598, ptr undef
  store ptr %.606, ptr %excinfo, align 8
  br label %common.ret
}

define linkonce_odr range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels5scene12march_blocks5_sumsB3v61B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29x5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, double %arg.lag, ptr %arg.track.0.0, ptr readnone captures(none) %arg.track.0.1, i64 %arg.track.0.2, i64 %arg.track.0.3, ptr readnone captures(none) %arg.track.0.4, i64 %arg.track.0.5.0, i64 %arg.track.0.5.1, i64 %arg.track.0.6.0, i64 %arg.track.0.6.1, ptr %arg.track.1.0, ptr readnone captures(none) %arg.track.1.1, i64 %arg.track.1.2, i64 %arg.track.1.3, ptr readonly captures(none) %arg.track.1.4, i64 %arg.track.1.5.0, i64 %arg.track.1.5.1, i64 %arg.track.1.6.0, i64 %arg.track.1.6.1, ptr %arg.track.2.0, ptr readnone captures(none) %arg.track.2.1, i64 %arg.track.2.2, i64 %arg.track.2.3, ptr readonly captures(none) %arg.track.2.4, i64 %arg.track.2.5.0, i64 %arg.track.2.6.0, ptr %arg.track.3.0, ptr readnone captures(none) %arg.track.3.1, i64 %arg.track.3.2, i64 %arg.track.3.3, ptr readonly captures(none) %arg.track.3.4, i64 %arg.track.3.5.0, i64 %arg.track.3.6.0, ptr %arg.track.4.0, ptr readnone captures(none) %arg.track.4.1, i64 %arg.track.4.2, i64 %arg.track.4.3, ptr readnone captures(none) %arg.track.4.4, i64 %arg.track.4.5.0, i64 %arg.track.4.6.0, ptr %arg.track.5.0, ptr readnone captures(none) %arg.track.5.1, i64 %arg.track.5.2, i64 %arg.track.5.3, ptr readnone captures(none) %arg.track.5.4, i64 %arg.track.5.5.0, i64 %arg.track.5.6.0, ptr %arg.track.6.0, ptr readnone captures(none) %arg.track.6.1, i64 %arg.track.6.2, i64 %arg.track.6.3, ptr readnone captures(none) %arg.track.6.4, i64 %arg.track.6.5.0, i64 %arg.track.6.6.0, i64 %arg.s, ptr %arg.some.0, ptr readnone captures(none) %arg.some.1, i64 %arg.some.2, i64 %arg.some.3, ptr readonly captures(none) %arg.some.4, i64 %arg.some.5.0, i64 %arg.some.6.0, ptr %arg.p.0, ptr readnone captures(none) %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr readonly captures(none) %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1) local_unnamed_addr {
B0.else.if:
  %.1499 = alloca { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, align 8
  %.fca.5.0.gep73 = getelementptr inbounds nuw i8, ptr %.1499, i64 40
  %.fca.6.0.gep75 = getelementptr inbounds nuw i8, ptr %.1499, i64 56
  %.1503 = alloca [1 x i64], align 8
  %.1557 = alloca [1 x i64], align 8
  store i64 0, ptr %.1557, align 8
  %.1627 = alloca { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, align 8
  %.fca.5.0.gep = getelementptr inbounds nuw i8, ptr %.1627, i64 40
  %.fca.6.0.gep = getelementptr inbounds nuw i8, ptr %.1627, i64 56
  %.1631 = alloca [1 x i64], align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.1627, i8 0, i64 72, i1 false)
  store i64 0, ptr %.1631, align 8
  %.1685 = alloca [1 x i64], align 8
  store i64 0, ptr %.1685, align 8
  %.1741 = alloca [3 x double], align 8
  %excinfo.7 = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.1741, i8 0, i64 24, i1 false)
  tail call void @NRT_incref(ptr %arg.some.0)
  tail call void @NRT_incref(ptr %arg.p.0)
  %.170.1 = ashr i64 %arg.track.0.5.1, 1
  tail call void @NRT_incref(ptr %arg.track.1.0), !noalias !376
  %.136.i = icmp slt i64 %arg.s, 0
  %.137.i = select i1 %.136.i, i64 %arg.track.3.5.0, i64 0
  %0 = getelementptr i64, ptr %arg.track.3.4, i64 %arg.s
  %.151.i = getelementptr i64, ptr %0, i64 %.137.i
  %.152.i = load i64, ptr %.151.i, align 8, !noalias !376
  %.198.i = select i1 %.136.i, i64 %arg.track.2.5.0, i64 0
  %1 = getelementptr i64, ptr %arg.track.2.4, i64 %arg.s
  %.212.i = getelementptr i64, ptr %1, i64 %.198.i
  %.213.i = load i64, ptr %.212.i, align 8, !noalias !376
  %.217.i = add nsw i64 %.152.i, %.170.1
  %.265.i = icmp slt i64 %.152.i, 0
  %.266.i = select i1 %.265.i, i64 %arg.track.1.5.1, i64 0
  %.267.i = add i64 %.266.i, %.152.i
  %.270.i = icmp slt i64 %.267.i, 0
  br i1 %.270.i, label %B0.else.if.i, label %B0.else.endif.i, !prof !11

B0.else.if.i:                                     ; preds = %B0.else.if
  br label %B0.else.endif.i

B0.else.endif.i:                                  ; preds = %B0.else.if.i, %B0.else.if
  %.255.sroa.0.1.i = phi i64 [ 0, %B0.else.if.i ], [ %.267.i, %B0.else.if ]
  %.275.not.i = icmp slt i64 %.267.i, %arg.track.1.5.1
  br i1 %.275.not.i, label %B0.else.endif.endif.i, label %B0.else.endif.if.i, !prof !12

B0.else.endif.if.i:                               ; preds = %B0.else.endif.i
  br label %B0.else.endif.endif.i

B0.else.endif.endif.i:                            ; preds = %B0.else.endif.if.i, %B0.else.endif.i
  %.255.sroa.0.3.i = phi i64 [ %arg.track.1.5.1, %B0.else.endif.if.i ], [ %.255.sroa.0.1.i, %B0.else.endif.i ]
  %.282.i = icmp slt i64 %.217.i, 0
  %.283.i = select i1 %.282.i, i64 %arg.track.1.5.1, i64 0
  %.284.i = add i64 %.283.i, %.217.i
  %.287.i = icmp slt i64 %.284.i, 0
  br i1 %.287.i, label %B0.else.endif.endif.if.i, label %B0.else.endif.endif.endif.i, !prof !11

B0.else.endif.endif.if.i:                         ; preds = %B0.else.endif.endif.i
  br label %B0.else.endif.endif.endif.i

B0.else.endif.endif.endif.i:                      ; preds = %B0.else.endif.endif.if.i, %B0.else.endif.endif.i
  %.255.sroa.13.1.i = phi i64 [ 0, %B0.else.endif.endif.if.i ], [ %.284.i, %B0.else.endif.endif.i ]
  %.292.not.i = icmp slt i64 %.284.i, %arg.track.1.5.1
  br i1 %.292.not.i, label %B0.endif.endif, label %B0.else.endif.endif.endif.if.i, !prof !12

B0.else.endif.endif.endif.if.i:                   ; preds = %B0.else.endif.endif.endif.i
  br label %B0.endif.endif

B490:                                             ; preds = %B490.preheader6, %B490
  %lsr.iv57 = phi i64 [ 0, %B490.preheader6 ], [ %lsr.iv.next58, %B490 ]
  %2 = shl i64 %lsr.iv57, 3
  %scevgep144 = getelementptr i8, ptr %scevgep132, i64 %2
  %scevgep145 = getelementptr i8, ptr %scevgep144, i64 -56
  %.1228 = load double, ptr %scevgep145, align 8
  %.1231 = fneg double %.1228
  %3 = shl i64 %lsr.iv57, 3
  %scevgep117 = getelementptr i8, ptr %scevgep115, i64 %3
  %scevgep118 = getelementptr i8, ptr %scevgep117, i64 -56
  store double %.1231, ptr %scevgep118, align 8
  %4 = shl i64 %lsr.iv57, 3
  %scevgep108 = getelementptr i8, ptr %scevgep96, i64 %4
  %scevgep109 = getelementptr i8, ptr %scevgep108, i64 -56
  %.1316 = load double, ptr %scevgep109, align 8
  %5 = shl i64 %lsr.iv57, 3
  %scevgep91 = getelementptr i8, ptr %scevgep79, i64 %5
  %scevgep92 = getelementptr i8, ptr %scevgep91, i64 -56
  %.1346 = load double, ptr %scevgep92, align 8
  %.1377 = fsub double %.1346, %.1316
  %.1379 = fmul double %arg.lag, %.1377
  %.1380 = fadd double %.1316, %.1379
  %6 = shl i64 %lsr.iv57, 3
  %scevgep64 = getelementptr i8, ptr %scevgep62, i64 %6
  %scevgep65 = getelementptr i8, ptr %scevgep64, i64 -32
  store double %.1380, ptr %scevgep65, align 8
  %scevgep146 = getelementptr i8, ptr %scevgep132, i64 %6
  %scevgep147 = getelementptr i8, ptr %scevgep146, i64 -48
  %.1228.1 = load double, ptr %scevgep147, align 8
  %.1231.1 = fneg double %.1228.1
  %7 = shl i64 %lsr.iv57, 3
  %scevgep119 = getelementptr i8, ptr %scevgep115, i64 %7
  %scevgep120 = getelementptr i8, ptr %scevgep119, i64 -48
  store double %.1231.1, ptr %scevgep120, align 8
  %8 = shl i64 %lsr.iv57, 3
  %scevgep110 = getelementptr i8, ptr %scevgep96, i64 %8
  %scevgep111 = getelementptr i8, ptr %scevgep110, i64 -48
  %.1316.1 = load double, ptr %scevgep111, align 8
  %9 = shl i64 %lsr.iv57, 3
  %scevgep93 = getelementptr i8, ptr %scevgep79, i64 %9
  %scevgep94 = getelementptr i8, ptr %scevgep93, i64 -48
  %.1346.1 = load double, ptr %scevgep94, align 8
  %.1377.1 = fsub double %.1346.1, %.1316.1
  %.1379.1 = fmul double %arg.lag, %.1377.1
  %.1380.1 = fadd double %.1316.1, %.1379.1
  %10 = shl i64 %lsr.iv57, 3
  %scevgep68 = getelementptr i8, ptr %scevgep62, i64 %10
  %scevgep69 = getelementptr i8, ptr %scevgep68, i64 -24
  store double %.1380.1, ptr %scevgep69, align 8
  %scevgep142 = getelementptr i8, ptr %scevgep132, i64 %10
  %scevgep143 = getelementptr i8, ptr %scevgep142, i64 -40
  %.1228.2 = load double, ptr %scevgep143, align 8
  %.1231.2 = fneg double %.1228.2
  %11 = shl i64 %lsr.iv57, 3
  %scevgep121 = getelementptr i8, ptr %scevgep115, i64 %11
  %scevgep122 = getelementptr i8, ptr %scevgep121, i64 -40
  store double %.1231.2, ptr %scevgep122, align 8
  %12 = shl i64 %lsr.iv57, 3
  %scevgep106 = getelementptr i8, ptr %scevgep96, i64 %12
  %scevgep107 = getelementptr i8, ptr %scevgep106, i64 -40
  %.1316.2 = load double, ptr %scevgep107, align 8
  %13 = shl i64 %lsr.iv57, 3
  %scevgep89 = getelementptr i8, ptr %scevgep79, i64 %13
  %scevgep90 = getelementptr i8, ptr %scevgep89, i64 -40
  %.1346.2 = load double, ptr %scevgep90, align 8
  %.1377.2 = fsub double %.1346.2, %.1316.2
  %.1379.2 = fmul double %arg.lag, %.1377.2
  %.1380.2 = fadd double %.1316.2, %.1379.2
  %14 = shl i64 %lsr.iv57, 3
  %scevgep70 = getelementptr i8, ptr %scevgep62, i64 %14
  %scevgep71 = getelementptr i8, ptr %scevgep70, i64 -16
  store double %.1380.2, ptr %scevgep71, align 8
  %scevgep140 = getelementptr i8, ptr %scevgep132, i64 %14
  %scevgep141 = getelementptr i8, ptr %scevgep140, i64 -32
  %.1228.3 = load double, ptr %scevgep141, align 8
  %.1231.3 = fneg double %.1228.3
  %15 = shl i64 %lsr.iv57, 3
  %scevgep123 = getelementptr i8, ptr %scevgep115, i64 %15
  %scevgep124 = getelementptr i8, ptr %scevgep123, i64 -32
  store double %.1231.3, ptr %scevgep124, align 8
  %16 = shl i64 %lsr.iv57, 3
  %scevgep104 = getelementptr i8, ptr %scevgep96, i64 %16
  %scevgep105 = getelementptr i8, ptr %scevgep104, i64 -32
  %.1316.3 = load double, ptr %scevgep105, align 8
  %17 = shl i64 %lsr.iv57, 3
  %scevgep87 = getelementptr i8, ptr %scevgep79, i64 %17
  %scevgep88 = getelementptr i8, ptr %scevgep87, i64 -32
  %.1346.3 = load double, ptr %scevgep88, align 8
  %.1377.3 = fsub double %.1346.3, %.1316.3
  %.1379.3 = fmul double %arg.lag, %.1377.3
  %.1380.3 = fadd double %.1316.3, %.1379.3
  %18 = shl i64 %lsr.iv57, 3
  %scevgep72 = getelementptr i8, ptr %scevgep62, i64 %18
  %scevgep73 = getelementptr i8, ptr %scevgep72, i64 -8
  store double %.1380.3, ptr %scevgep73, align 8
  %scevgep138 = getelementptr i8, ptr %scevgep132, i64 %18
  %scevgep139 = getelementptr i8, ptr %scevgep138, i64 -24
  %.1228.4 = load double, ptr %scevgep139, align 8
  %.1231.4 = fneg double %.1228.4
  %19 = shl i64 %lsr.iv57, 3
  %scevgep125 = getelementptr i8, ptr %scevgep115, i64 %19
  %scevgep126 = getelementptr i8, ptr %scevgep125, i64 -24
  store double %.1231.4, ptr %scevgep126, align 8
  %20 = shl i64 %lsr.iv57, 3
  %scevgep102 = getelementptr i8, ptr %scevgep96, i64 %20
  %scevgep103 = getelementptr i8, ptr %scevgep102, i64 -24
  %.1316.4 = load double, ptr %scevgep103, align 8
  %21 = shl i64 %lsr.iv57, 3
  %scevgep85 = getelementptr i8, ptr %scevgep79, i64 %21
  %scevgep86 = getelementptr i8, ptr %scevgep85, i64 -24
  %.1346.4 = load double, ptr %scevgep86, align 8
  %.1377.4 = fsub double %.1346.4, %.1316.4
  %.1379.4 = fmul double %arg.lag, %.1377.4
  %.1380.4 = fadd double %.1316.4, %.1379.4
  %22 = shl i64 %lsr.iv57, 3
  %scevgep63 = getelementptr i8, ptr %scevgep62, i64 %22
  store double %.1380.4, ptr %scevgep63, align 8
  %scevgep136 = getelementptr i8, ptr %scevgep132, i64 %22
  %scevgep137 = getelementptr i8, ptr %scevgep136, i64 -16
  %.1228.5 = load double, ptr %scevgep137, align 8
  %.1231.5 = fneg double %.1228.5
  %23 = shl i64 %lsr.iv57, 3
  %scevgep127 = getelementptr i8, ptr %scevgep115, i64 %23
  %scevgep128 = getelementptr i8, ptr %scevgep127, i64 -16
  store double %.1231.5, ptr %scevgep128, align 8
  %24 = shl i64 %lsr.iv57, 3
  %scevgep100 = getelementptr i8, ptr %scevgep96, i64 %24
  %scevgep101 = getelementptr i8, ptr %scevgep100, i64 -16
  %.1316.5 = load double, ptr %scevgep101, align 8
  %25 = shl i64 %lsr.iv57, 3
  %scevgep83 = getelementptr i8, ptr %scevgep79, i64 %25
  %scevgep84 = getelementptr i8, ptr %scevgep83, i64 -16
  %.1346.5 = load double, ptr %scevgep84, align 8
  %.1377.5 = fsub double %.1346.5, %.1316.5
  %.1379.5 = fmul double %arg.lag, %.1377.5
  %.1380.5 = fadd double %.1316.5, %.1379.5
  %26 = shl i64 %lsr.iv57, 3
  %scevgep76 = getelementptr i8, ptr %scevgep62, i64 %26
  %scevgep77 = getelementptr i8, ptr %scevgep76, i64 8
  store double %.1380.5, ptr %scevgep77, align 8
  %scevgep134 = getelementptr i8, ptr %scevgep132, i64 %26
  %scevgep135 = getelementptr i8, ptr %scevgep134, i64 -8
  %.1228.6 = load double, ptr %scevgep135, align 8
  %.1231.6 = fneg double %.1228.6
  %27 = shl i64 %lsr.iv57, 3
  %scevgep129 = getelementptr i8, ptr %scevgep115, i64 %27
  %scevgep130 = getelementptr i8, ptr %scevgep129, i64 -8
  store double %.1231.6, ptr %scevgep130, align 8
  %28 = shl i64 %lsr.iv57, 3
  %scevgep98 = getelementptr i8, ptr %scevgep96, i64 %28
  %scevgep99 = getelementptr i8, ptr %scevgep98, i64 -8
  %.1316.6 = load double, ptr %scevgep99, align 8
  %29 = shl i64 %lsr.iv57, 3
  %scevgep81 = getelementptr i8, ptr %scevgep79, i64 %29
  %scevgep82 = getelementptr i8, ptr %scevgep81, i64 -8
  %.1346.6 = load double, ptr %scevgep82, align 8
  %.1377.6 = fsub double %.1346.6, %.1316.6
  %.1379.6 = fmul double %arg.lag, %.1377.6
  %.1380.6 = fadd double %.1316.6, %.1379.6
  %30 = shl i64 %lsr.iv57, 3
  %scevgep74 = getelementptr i8, ptr %scevgep62, i64 %30
  %scevgep75 = getelementptr i8, ptr %scevgep74, i64 16
  store double %.1380.6, ptr %scevgep75, align 8
  %scevgep133 = getelementptr i8, ptr %scevgep132, i64 %30
  %.1228.7 = load double, ptr %scevgep133, align 8
  %.1231.7 = fneg double %.1228.7
  %31 = shl i64 %lsr.iv57, 3
  %scevgep116 = getelementptr i8, ptr %scevgep115, i64 %31
  store double %.1231.7, ptr %scevgep116, align 8
  %32 = shl i64 %lsr.iv57, 3
  %scevgep97 = getelementptr i8, ptr %scevgep96, i64 %32
  %.1316.7 = load double, ptr %scevgep97, align 8
  %33 = shl i64 %lsr.iv57, 3
  %scevgep80 = getelementptr i8, ptr %scevgep79, i64 %33
  %.1346.7 = load double, ptr %scevgep80, align 8
  %.1377.7 = fsub double %.1346.7, %.1316.7
  %.1379.7 = fmul double %arg.lag, %.1377.7
  %.1380.7 = fadd double %.1316.7, %.1379.7
  %34 = shl i64 %lsr.iv57, 3
  %scevgep66 = getelementptr i8, ptr %scevgep62, i64 %34
  %scevgep67 = getelementptr i8, ptr %scevgep66, i64 24
  store double %.1380.7, ptr %scevgep67, align 8
  %lsr.iv.next58 = add i64 %lsr.iv57, 8
  %exitcond.not.7 = icmp eq i64 %152, %lsr.iv.next58
  br i1 %exitcond.not.7, label %B594, label %B490, !llvm.loop !379

B594:                                             ; preds = %B490, %B490.prol.loopexit, %vec.epilog.middle.block, %middle.block, %B314.endif.endif.endif
  %scevgep8 = getelementptr i8, ptr %lsr.iv, i64 512
  %scevgep21 = getelementptr i8, ptr %lsr.iv20, i64 512
  %scevgep30 = getelementptr i8, ptr %lsr.iv29, i64 512
  %scevgep40 = getelementptr i8, ptr %lsr.iv39, i64 512
  %scevgep61 = getelementptr i8, ptr %lsr.iv60, i64 512
  %scevgep114 = getelementptr i8, ptr %lsr.iv113, i64 512
  %exitcond859.not = icmp eq i64 %arg.some.2, %.620
  br i1 %exitcond859.not, label %B192.else.if.i, label %B314.else

B192.else.if.i:                                   ; preds = %B594, %B0.endif.endif.endif.endif.endif.endif
  store ptr %.7.i.i.i.i, ptr %.1499, align 8
  %sunkaddr = getelementptr inbounds i8, ptr %.1499, i64 8
  store ptr null, ptr %sunkaddr, align 8
  %sunkaddr148 = getelementptr inbounds i8, ptr %.1499, i64 16
  store i64 %.51.i.i, ptr %sunkaddr148, align 8
  %sunkaddr149 = getelementptr inbounds i8, ptr %.1499, i64 24
  store i64 8, ptr %sunkaddr149, align 8
  %sunkaddr150 = getelementptr inbounds i8, ptr %.1499, i64 32
  store ptr %.6.i.i.i, ptr %sunkaddr150, align 8
  %sunkaddr151 = getelementptr inbounds i8, ptr %.1499, i64 40
  store i64 %arg.some.2, ptr %sunkaddr151, align 8
  %sunkaddr152 = getelementptr inbounds i8, ptr %.1499, i64 48
  store i64 64, ptr %sunkaddr152, align 8
  %sunkaddr153 = getelementptr inbounds i8, ptr %.1499, i64 56
  store i64 512, ptr %sunkaddr153, align 8
  %sunkaddr154 = getelementptr inbounds i8, ptr %.1499, i64 64
  store i64 8, ptr %sunkaddr154, align 8
  store i64 %.51.i.i, ptr %.1503, align 8, !noalias !380
  tail call void @NRT_decref(ptr %arg.some.0)
  tail call void @NRT_decref(ptr %arg.p.0)
  tail call void @NRT_decref(ptr %arg.track.1.0)
  tail call void @NRT_decref(ptr %arg.track.1.0)
  %.1567 = call i32 @numba_attempt_nocopy_reshape(i64 2, ptr nonnull %.fca.5.0.gep73, ptr nonnull %.fca.6.0.gep75, i64 1, ptr nonnull %.1503, ptr nonnull %.1557, i64 8, i32 0)
  %.1568 = icmp eq i32 %.1567, 0
  br i1 %.1568, label %B596.endif.if, label %B192.else.if.i104

B0.endif.endif:                                   ; preds = %B0.else.endif.endif.endif.if.i, %B0.else.endif.endif.endif.i
  %.255.sroa.13.0.i = phi i64 [ %.255.sroa.13.1.i, %B0.else.endif.endif.endif.i ], [ %arg.track.1.5.1, %B0.else.endif.endif.endif.if.i ]
  %.252.i = icmp slt i64 %.213.i, 0
  %.253.i = select i1 %.252.i, i64 %arg.track.1.5.0, i64 0
  %.254.i = add i64 %.253.i, %.213.i
  %.343.i = sub i64 %.255.sroa.13.0.i, %.255.sroa.0.3.i
  %.352.i = tail call i64 @llvm.smax.i64(i64 %.343.i, i64 0)
  %.372.i = mul i64 %.254.i, %arg.track.1.5.1
  %35 = getelementptr double, ptr %arg.track.1.4, i64 %.372.i
  %.376.i = getelementptr double, ptr %35, i64 %.255.sroa.0.3.i
  %.281 = add nsw i64 %arg.s, 1
  tail call void @NRT_incref(ptr %arg.track.1.0), !noalias !384
  %.136.i6 = icmp slt i64 %arg.s, -1
  %.137.i7 = select i1 %.136.i6, i64 %arg.track.3.5.0, i64 0
  %36 = getelementptr i64, ptr %arg.track.3.4, i64 %.281
  %.151.i8 = getelementptr i64, ptr %36, i64 %.137.i7
  %.152.i9 = load i64, ptr %.151.i8, align 8, !noalias !384
  %.198.i10 = select i1 %.136.i6, i64 %arg.track.2.5.0, i64 0
  %37 = getelementptr i64, ptr %arg.track.2.4, i64 %.281
  %.212.i11 = getelementptr i64, ptr %37, i64 %.198.i10
  %.213.i12 = load i64, ptr %.212.i11, align 8, !noalias !384
  %.217.i13 = add nsw i64 %.152.i9, %.170.1
  %.265.i14 = icmp slt i64 %.152.i9, 0
  %.266.i15 = select i1 %.265.i14, i64 %arg.track.1.5.1, i64 0
  %.267.i16 = add i64 %.266.i15, %.152.i9
  %.270.i17 = icmp slt i64 %.267.i16, 0
  br i1 %.270.i17, label %B0.else.if.i47, label %B0.else.endif.i18, !prof !11

B0.else.if.i47:                                   ; preds = %B0.endif.endif
  br label %B0.else.endif.i18

B0.else.endif.i18:                                ; preds = %B0.else.if.i47, %B0.endif.endif
  %.255.sroa.0.1.i19 = phi i64 [ 0, %B0.else.if.i47 ], [ %.267.i16, %B0.endif.endif ]
  %.275.not.i20 = icmp slt i64 %.267.i16, %arg.track.1.5.1
  br i1 %.275.not.i20, label %B0.else.endif.endif.i22, label %B0.else.endif.if.i21, !prof !12

B0.else.endif.if.i21:                             ; preds = %B0.else.endif.i18
  br label %B0.else.endif.endif.i22

B0.else.endif.endif.i22:                          ; preds = %B0.else.endif.if.i21, %B0.else.endif.i18
  %.255.sroa.0.3.i23 = phi i64 [ %arg.track.1.5.1, %B0.else.endif.if.i21 ], [ %.255.sroa.0.1.i19, %B0.else.endif.i18 ]
  %.282.i24 = icmp slt i64 %.217.i13, 0
  %.283.i25 = select i1 %.282.i24, i64 %arg.track.1.5.1, i64 0
  %.284.i26 = add i64 %.283.i25, %.217.i13
  %.287.i27 = icmp slt i64 %.284.i26, 0
  br i1 %.287.i27, label %B0.else.endif.endif.if.i46, label %B0.else.endif.endif.endif.i28, !prof !11

B0.else.endif.endif.if.i46:                       ; preds = %B0.else.endif.endif.i22
  br label %B0.else.endif.endif.endif.i28

B0.else.endif.endif.endif.i28:                    ; preds = %B0.else.endif.endif.if.i46, %B0.else.endif.endif.i22
  %.255.sroa.13.1.i29 = phi i64 [ 0, %B0.else.endif.endif.if.i46 ], [ %.284.i26, %B0.else.endif.endif.i22 ]
  %.292.not.i30 = icmp slt i64 %.284.i26, %arg.track.1.5.1
  br i1 %.292.not.i30, label %B0.endif.endif.endif, label %B0.else.endif.endif.endif.if.i31, !prof !12

B0.else.endif.endif.endif.if.i31:                 ; preds = %B0.else.endif.endif.endif.i28
  br label %B0.endif.endif.endif

common.ret:                                       ; preds = %B596.endif.endif.endif.endif.if.if, %B596.endif.endif.endif.endif.endif, %B596.endif.endif.endif.if, %B596.endif.if, %B0.endif.endif.endif.endif.if.if, %B0.endif.endif.endif.if.if
  %common.ret.op = phi i32 [ %.1749, %B596.endif.endif.endif.endif.if.if ], [ 0, %B596.endif.endif.endif.endif.endif ], [ 1, %B0.endif.endif.endif.if.if ], [ 1, %B0.endif.endif.endif.endif.if.if ], [ 1, %B596.endif.endif.endif.if ], [ 1, %B596.endif.if ]
  ret i32 %common.ret.op

B0.endif.endif.endif:                             ; preds = %B0.else.endif.endif.endif.if.i31, %B0.else.endif.endif.endif.i28
  %.255.sroa.13.0.i32 = phi i64 [ %.255.sroa.13.1.i29, %B0.else.endif.endif.endif.i28 ], [ %arg.track.1.5.1, %B0.else.endif.endif.endif.if.i31 ]
  %.252.i33 = icmp slt i64 %.213.i12, 0
  %.253.i34 = select i1 %.252.i33, i64 %arg.track.1.5.0, i64 0
  %.254.i35 = add i64 %.253.i34, %.213.i12
  %.343.i36 = sub i64 %.255.sroa.13.0.i32, %.255.sroa.0.3.i23
  %.352.i37 = tail call i64 @llvm.smax.i64(i64 %.343.i36, i64 0)
  %.372.i38 = mul i64 %.254.i35, %arg.track.1.5.1
  %38 = getelementptr double, ptr %arg.track.1.4, i64 %.372.i38
  %.376.i39 = getelementptr double, ptr %38, i64 %.255.sroa.0.3.i23
  %.29.i.i = icmp slt i64 %arg.some.2, 0
  br i1 %.29.i.i, label %B0.endif.endif.endif.if.if, label %B0.endif.endif.endif.endif.i.i, !prof !13

B0.endif.endif.endif.endif.i.i:                   ; preds = %B0.endif.endif.endif
  %.51.i.i = shl i64 %arg.some.2, 6
  %.52.i.i = icmp samesign ugt i64 %arg.some.2, 144115188075855871
  %39 = add i64 %.51.i.i, -1152921504606846976
  %.57.i.i = icmp ult i64 %39, -2305843009213693952
  %.58.i.i = or i1 %.52.i.i, %.57.i.i
  br i1 %.58.i.i, label %B0.endif.endif.endif.if.if, label %B0.endif.endif.endif.endif.endif.i.i, !prof !11

B0.endif.endif.endif.endif.endif.i.i:             ; preds = %B0.endif.endif.endif.endif.i.i
  %.56.i.i = shl i64 %arg.some.2, 9
  %.7.i.i.i.i = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.56.i.i, i32 32), !noalias !387
  %.8.i.i.i.i = icmp eq ptr %.7.i.i.i.i, null
  br i1 %.8.i.i.i.i, label %B0.endif.endif.endif.if.if, label %B0.endif.endif.endif.endif.endif.i.i57, !prof !11

B0.endif.endif.endif.endif.endif.i.i57:           ; preds = %B0.endif.endif.endif.endif.endif.i.i
  %.5.i.i.i = getelementptr i8, ptr %.7.i.i.i.i, i64 24
  %.6.i.i.i = load ptr, ptr %.5.i.i.i, align 8, !noalias !400
  tail call void @llvm.memset.p0.i64(ptr align 1 %.6.i.i.i, i8 0, i64 %.56.i.i, i1 false), !noalias !401
  %.7.i.i.i.i59 = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.56.i.i, i32 32), !noalias !404
  %.8.i.i.i.i60 = icmp eq ptr %.7.i.i.i.i59, null
  br i1 %.8.i.i.i.i60, label %B0.endif.endif.endif.endif.if.if, label %B0.endif.endif.endif.endif.endif.endif, !prof !11

B0.endif.endif.endif.if.if:                       ; preds = %B0.endif.endif.endif.endif.endif.i.i, %B0.endif.endif.endif.endif.i.i, %B0.endif.endif.endif
  %excinfo.3.0.ph = phi ptr [ @.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b.39, %B0.endif.endif.endif ], [ @.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57.40, %B0.endif.endif.endif.endif.i.i ], [ @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.41, %B0.endif.endif.endif.endif.endif.i.i ]
  store ptr %excinfo.3.0.ph, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif.if.if:                 ; preds = %B0.endif.endif.endif.endif.endif.i.i57
  store ptr @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.41, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif.endif.endif:           ; preds = %B0.endif.endif.endif.endif.endif.i.i57
  %.5.i.i.i62 = getelementptr i8, ptr %.7.i.i.i.i59, i64 24
  %.6.i.i.i63 = load ptr, ptr %.5.i.i.i62, align 8, !noalias !417
  tail call void @llvm.memset.p0.i64(ptr align 1 %.6.i.i.i63, i8 0, i64 %.56.i.i, i1 false), !noalias !418
  %.607852.not = icmp eq i64 %arg.some.2, 0
  br i1 %.607852.not, label %B192.else.if.i, label %B314.else.preheader

B314.else.preheader:                              ; preds = %B0.endif.endif.endif.endif.endif.endif
  %const = bitcast i64 9223372036854775792 to i64
  %40 = add i64 %.255.sroa.0.3.i, %.372.i
  %41 = add i64 %.255.sroa.0.3.i23, %.372.i38
  %broadcast.splatinsert = insertelement <8 x double> poison, double %arg.lag, i64 0
  %broadcast.splat = shufflevector <8 x double> %broadcast.splatinsert, <8 x double> poison, <8 x i32> zeroinitializer
  %broadcast.splatinsert203 = insertelement <4 x double> poison, double %arg.lag, i64 0
  %broadcast.splat204 = shufflevector <4 x double> %broadcast.splatinsert203, <4 x double> poison, <4 x i32> zeroinitializer
  %scevgep7 = getelementptr i8, ptr %.6.i.i.i63, i64 64
  %42 = mul i64 %arg.track.1.5.1, %.254.i
  %43 = shl i64 %42, 3
  %44 = shl i64 %.255.sroa.0.3.i, 3
  %45 = add i64 %43, %44
  %46 = add i64 %45, 64
  %scevgep11 = getelementptr i8, ptr %arg.track.1.4, i64 %46
  %47 = mul i64 %arg.track.1.5.1, %.254.i35
  %48 = shl i64 %47, 3
  %49 = shl i64 %.255.sroa.0.3.i23, 3
  %50 = add i64 %48, %49
  %51 = add i64 %50, 64
  %scevgep15 = getelementptr i8, ptr %arg.track.1.4, i64 %51
  %scevgep19 = getelementptr i8, ptr %.6.i.i.i, i64 64
  %scevgep24 = getelementptr i8, ptr %arg.p.4, i64 64
  %52 = shl i64 %arg.p.5.1, 3
  %53 = mul i64 %arg.track.1.5.1, %.254.i
  %54 = shl i64 %53, 3
  %55 = shl i64 %.255.sroa.0.3.i, 3
  %56 = add i64 %54, %55
  %scevgep33 = getelementptr i8, ptr %arg.track.1.4, i64 %56
  %57 = mul i64 %arg.track.1.5.1, %.254.i35
  %58 = shl i64 %57, 3
  %59 = shl i64 %.255.sroa.0.3.i23, 3
  %60 = add i64 %58, %59
  %scevgep36 = getelementptr i8, ptr %arg.track.1.4, i64 %60
  %61 = shl i64 %arg.p.5.1, 3
  %62 = mul i64 %arg.track.1.5.1, %.254.i
  %63 = shl i64 %62, 3
  %64 = shl i64 %.255.sroa.0.3.i, 3
  %65 = add i64 %63, %64
  %scevgep47 = getelementptr i8, ptr %arg.track.1.4, i64 %65
  %66 = mul i64 %arg.track.1.5.1, %.254.i35
  %67 = shl i64 %66, 3
  %68 = shl i64 %.255.sroa.0.3.i23, 3
  %69 = add i64 %67, %68
  %scevgep50 = getelementptr i8, ptr %arg.track.1.4, i64 %69
  %70 = shl i64 %arg.p.5.1, 3
  %scevgep59 = getelementptr i8, ptr %.6.i.i.i63, i64 32
  %71 = mul i64 %arg.track.1.5.1, %.254.i
  %72 = shl i64 %71, 3
  %73 = shl i64 %.255.sroa.0.3.i, 3
  %74 = add i64 %72, %73
  %75 = add i64 %74, 56
  %scevgep78 = getelementptr i8, ptr %arg.track.1.4, i64 %75
  %76 = mul i64 %arg.track.1.5.1, %.254.i35
  %77 = shl i64 %76, 3
  %78 = shl i64 %.255.sroa.0.3.i23, 3
  %79 = add i64 %77, %78
  %80 = add i64 %79, 56
  %scevgep95 = getelementptr i8, ptr %arg.track.1.4, i64 %80
  %scevgep112 = getelementptr i8, ptr %.6.i.i.i, i64 56
  %scevgep131 = getelementptr i8, ptr %arg.p.4, i64 56
  %81 = shl i64 %arg.p.5.1, 3
  br label %B314.else

B314.else:                                        ; preds = %B314.else.preheader, %B594
  %lsr.iv113 = phi ptr [ %scevgep112, %B314.else.preheader ], [ %scevgep114, %B594 ]
  %lsr.iv60 = phi ptr [ %scevgep59, %B314.else.preheader ], [ %scevgep61, %B594 ]
  %lsr.iv39 = phi ptr [ %.6.i.i.i, %B314.else.preheader ], [ %scevgep40, %B594 ]
  %lsr.iv29 = phi ptr [ %.6.i.i.i63, %B314.else.preheader ], [ %scevgep30, %B594 ]
  %lsr.iv20 = phi ptr [ %scevgep19, %B314.else.preheader ], [ %scevgep21, %B594 ]
  %lsr.iv = phi ptr [ %scevgep7, %B314.else.preheader ], [ %scevgep8, %B594 ]
  %.613847853 = phi i64 [ %.620, %B594 ], [ 0, %B314.else.preheader ]
  %82 = shl i64 %.613847853, 9
  %scevgep = getelementptr i8, ptr %.6.i.i.i, i64 %82
  %scevgep167 = getelementptr i8, ptr %.6.i.i.i63, i64 %82
  %.620 = add nuw nsw i64 %.613847853, 1
  %83 = getelementptr i64, ptr %arg.some.4, i64 %.613847853
  %.678 = load i64, ptr %83, align 8
  %.683 = shl i64 %.678, 6
  %.686 = add i64 %.683, 64
  %.723 = icmp slt i64 %.678, 0
  %.724 = select i1 %.723, i64 %.352.i, i64 0
  %.725 = add i64 %.724, %.683
  %.728 = icmp slt i64 %.725, 0
  br i1 %.728, label %B314.else.if, label %B314.else.endif, !prof !11

B314.else.if:                                     ; preds = %B314.else
  br label %B314.else.endif

B314.else.endif:                                  ; preds = %B314.else.if, %B314.else
  %.713.sroa.0.1 = phi i64 [ 0, %B314.else.if ], [ %.725, %B314.else ]
  %.733.not = icmp slt i64 %.725, %.352.i
  br i1 %.733.not, label %B314.else.endif.endif, label %B314.else.endif.if, !prof !12

B314.else.endif.if:                               ; preds = %B314.else.endif
  br label %B314.else.endif.endif

B314.else.endif.endif:                            ; preds = %B314.else.endif.if, %B314.else.endif
  %.713.sroa.0.3 = phi i64 [ %.352.i, %B314.else.endif.if ], [ %.713.sroa.0.1, %B314.else.endif ]
  %84 = icmp slt i64 %.678, 0
  %.826 = getelementptr double, ptr %.376.i, i64 %.713.sroa.0.3
  %.900 = select i1 %84, i64 %.352.i37, i64 0
  %.901 = add i64 %.900, %.683
  %.904 = icmp slt i64 %.901, 0
  br i1 %.904, label %B314.endif.else.if, label %B314.endif.else.endif, !prof !11

B314.endif.else.if:                               ; preds = %B314.else.endif.endif
  br label %B314.endif.else.endif

B314.endif.else.endif:                            ; preds = %B314.endif.else.if, %B314.else.endif.endif
  %.889.sroa.0.1 = phi i64 [ 0, %B314.endif.else.if ], [ %.901, %B314.else.endif.endif ]
  %.909.not = icmp slt i64 %.901, %.352.i37
  br i1 %.909.not, label %B314.endif.else.endif.endif, label %B314.endif.else.endif.if, !prof !12

B314.endif.else.endif.if:                         ; preds = %B314.endif.else.endif
  br label %B314.endif.else.endif.endif

B314.endif.else.endif.endif:                      ; preds = %B314.endif.else.endif.if, %B314.endif.else.endif
  %.889.sroa.0.3 = phi i64 [ %.352.i37, %B314.endif.else.endif.if ], [ %.889.sroa.0.1, %B314.endif.else.endif ]
  %85 = icmp slt i64 %.686, 0
  %.917 = select i1 %85, i64 %.352.i37, i64 0
  %.918 = add i64 %.917, %.686
  %.921 = icmp slt i64 %.918, 0
  br i1 %.921, label %B314.endif.else.endif.endif.if, label %B314.endif.else.endif.endif.endif, !prof !11

B314.endif.else.endif.endif.if:                   ; preds = %B314.endif.else.endif.endif
  br label %B314.endif.else.endif.endif.endif

B314.endif.else.endif.endif.endif:                ; preds = %B314.endif.else.endif.endif.if, %B314.endif.else.endif.endif
  %.889.sroa.13.1 = phi i64 [ 0, %B314.endif.else.endif.endif.if ], [ %.918, %B314.endif.else.endif.endif ]
  %.926.not = icmp slt i64 %.918, %.352.i37
  br i1 %.926.not, label %B314.endif.endif.endif, label %B314.endif.else.endif.endif.endif.if, !prof !12

B314.endif.else.endif.endif.endif.if:             ; preds = %B314.endif.else.endif.endif.endif
  br label %B314.endif.endif.endif

B314.endif.endif.endif:                           ; preds = %B314.endif.else.endif.endif.endif.if, %B314.endif.else.endif.endif.endif
  %.889.sroa.13.0 = phi i64 [ %.889.sroa.13.1, %B314.endif.else.endif.endif.endif ], [ %.352.i37, %B314.endif.else.endif.endif.endif.if ]
  %.977 = sub nsw i64 %.889.sroa.13.0, %.889.sroa.0.3
  %.1002 = getelementptr double, ptr %.376.i39, i64 %.889.sroa.0.3
  %.1138842.not = icmp slt i64 %.977, 1
  br i1 %.1138842.not, label %B594, label %iter.check

iter.check:                                       ; preds = %B314.endif.endif.endif
  %86 = icmp slt i64 %.678, 0
  %.1202 = select i1 %86, i64 %arg.p.5.0, i64 0
  %.1203 = add i64 %.1202, %.678
  %.1223 = mul i64 %.1203, %arg.p.5.1
  %87 = getelementptr double, ptr %arg.p.4, i64 %.1223
  %min.iters.check = icmp samesign ult i64 %.977, 4
  br i1 %min.iters.check, label %B490.preheader, label %vector.memcheck

vector.memcheck:                                  ; preds = %iter.check
  %88 = shl i64 %.977, 3
  %scevgep166 = getelementptr i8, ptr %scevgep, i64 %88
  %scevgep168 = getelementptr i8, ptr %scevgep167, i64 %88
  %89 = sub i64 %.1223, %.889.sroa.0.3
  %90 = add i64 %89, %.889.sroa.13.0
  %91 = shl i64 %90, 3
  %scevgep169 = getelementptr i8, ptr %arg.p.4, i64 %91
  %92 = add i64 %40, %.713.sroa.0.3
  %93 = sub i64 %92, %.889.sroa.0.3
  %94 = add i64 %93, %.889.sroa.13.0
  %95 = shl i64 %94, 3
  %scevgep170 = getelementptr i8, ptr %arg.track.1.4, i64 %95
  %96 = add i64 %41, %.889.sroa.13.0
  %97 = shl i64 %96, 3
  %scevgep171 = getelementptr i8, ptr %arg.track.1.4, i64 %97
  %bound0 = icmp ult ptr %scevgep, %scevgep168
  %bound1 = icmp ult ptr %scevgep167, %scevgep166
  %found.conflict = and i1 %bound0, %bound1
  %bound0172 = icmp ult ptr %scevgep, %scevgep169
  %bound1173 = icmp ult ptr %87, %scevgep166
  %found.conflict174 = and i1 %bound0172, %bound1173
  %conflict.rdx = or i1 %found.conflict, %found.conflict174
  %bound0175 = icmp ult ptr %scevgep, %scevgep170
  %bound1176 = icmp ult ptr %.826, %scevgep166
  %found.conflict177 = and i1 %bound0175, %bound1176
  %conflict.rdx178 = or i1 %found.conflict177, %conflict.rdx
  %bound0179 = icmp ult ptr %scevgep, %scevgep171
  %bound1180 = icmp ult ptr %.1002, %scevgep166
  %found.conflict181 = and i1 %bound0179, %bound1180
  %conflict.rdx182 = or i1 %found.conflict181, %conflict.rdx178
  %bound0183 = icmp ult ptr %scevgep167, %scevgep169
  %bound1184 = icmp ult ptr %87, %scevgep168
  %found.conflict185 = and i1 %bound0183, %bound1184
  %conflict.rdx186 = or i1 %found.conflict185, %conflict.rdx182
  %bound0187 = icmp ult ptr %scevgep167, %scevgep170
  %bound1188 = icmp ult ptr %.826, %scevgep168
  %found.conflict189 = and i1 %bound0187, %bound1188
  %conflict.rdx190 = or i1 %found.conflict189, %conflict.rdx186
  %bound0191 = icmp ult ptr %scevgep167, %scevgep171
  %bound1192 = icmp ult ptr %.1002, %scevgep168
  %found.conflict193 = and i1 %bound0191, %bound1192
  %conflict.rdx194 = or i1 %found.conflict193, %conflict.rdx190
  br i1 %conflict.rdx194, label %B490.preheader, label %vector.main.loop.iter.check

vector.main.loop.iter.check:                      ; preds = %vector.memcheck
  %min.iters.check195 = icmp samesign ult i64 %.977, 16
  br i1 %min.iters.check195, label %vec.epilog.ph, label %vector.ph

vector.ph:                                        ; preds = %vector.main.loop.iter.check
  %n.vec = and i64 %.977, %const
  %98 = shl i64 %.713.sroa.0.3, 3
  %scevgep12 = getelementptr i8, ptr %scevgep11, i64 %98
  %99 = shl i64 %.889.sroa.0.3, 3
  %scevgep16 = getelementptr i8, ptr %scevgep15, i64 %99
  %100 = mul i64 %52, %.1203
  %scevgep25 = getelementptr i8, ptr %scevgep24, i64 %100
  br label %vector.body

vector.body:                                      ; preds = %vector.body, %vector.ph
  %index = phi i64 [ 0, %vector.ph ], [ %index.next, %vector.body ]
  %101 = shl i64 %index, 3
  %scevgep26 = getelementptr i8, ptr %scevgep25, i64 %101
  %scevgep27 = getelementptr i8, ptr %scevgep26, i64 -64
  %wide.load = load <8 x double>, ptr %scevgep27, align 8, !alias.scope !421
  %wide.load196 = load <8 x double>, ptr %scevgep26, align 8, !alias.scope !421
  %102 = fneg <8 x double> %wide.load
  %103 = fneg <8 x double> %wide.load196
  %104 = shl i64 %index, 3
  %scevgep22 = getelementptr i8, ptr %lsr.iv20, i64 %104
  %scevgep23 = getelementptr i8, ptr %scevgep22, i64 -64
  store <8 x double> %102, ptr %scevgep23, align 8, !alias.scope !424, !noalias !426
  store <8 x double> %103, ptr %scevgep22, align 8, !alias.scope !424, !noalias !426
  %105 = shl i64 %index, 3
  %scevgep17 = getelementptr i8, ptr %scevgep16, i64 %105
  %scevgep18 = getelementptr i8, ptr %scevgep17, i64 -64
  %wide.load197 = load <8 x double>, ptr %scevgep18, align 8, !alias.scope !430
  %wide.load198 = load <8 x double>, ptr %scevgep17, align 8, !alias.scope !430
  %106 = shl i64 %index, 3
  %scevgep13 = getelementptr i8, ptr %scevgep12, i64 %106
  %scevgep14 = getelementptr i8, ptr %scevgep13, i64 -64
  %wide.load199 = load <8 x double>, ptr %scevgep14, align 8, !alias.scope !431
  %wide.load200 = load <8 x double>, ptr %scevgep13, align 8, !alias.scope !431
  %107 = fsub <8 x double> %wide.load199, %wide.load197
  %108 = fsub <8 x double> %wide.load200, %wide.load198
  %109 = fmul <8 x double> %broadcast.splat, %107
  %110 = fmul <8 x double> %broadcast.splat, %108
  %111 = fadd <8 x double> %wide.load197, %109
  %112 = fadd <8 x double> %wide.load198, %110
  %113 = shl i64 %index, 3
  %scevgep9 = getelementptr i8, ptr %lsr.iv, i64 %113
  %scevgep10 = getelementptr i8, ptr %scevgep9, i64 -64
  store <8 x double> %111, ptr %scevgep10, align 8, !alias.scope !432, !noalias !433
  store <8 x double> %112, ptr %scevgep9, align 8, !alias.scope !432, !noalias !433
  %index.next = add nuw i64 %index, 16
  %114 = icmp eq i64 %n.vec, %index.next
  br i1 %114, label %middle.block, label %vector.body, !llvm.loop !434

middle.block:                                     ; preds = %vector.body
  %cmp.n = icmp eq i64 %.977, %n.vec
  br i1 %cmp.n, label %B594, label %vec.epilog.iter.check

vec.epilog.iter.check:                            ; preds = %middle.block
  %n.mod.vf = and i64 %.977, 12
  %min.epilog.iters.check = icmp eq i64 %n.mod.vf, 0
  br i1 %min.epilog.iters.check, label %B490.preheader, label %vec.epilog.ph, !prof !435

vec.epilog.ph:                                    ; preds = %vec.epilog.iter.check, %vector.main.loop.iter.check
  %vec.epilog.resume.val = phi i64 [ %n.vec, %vec.epilog.iter.check ], [ 0, %vector.main.loop.iter.check ]
  %const_mat = add i64 %const, 12
  %n.vec202 = and i64 %.977, %const_mat
  %115 = sub i64 %n.vec202, %vec.epilog.resume.val
  %116 = shl i64 %vec.epilog.resume.val, 3
  %scevgep31 = getelementptr i8, ptr %lsr.iv29, i64 %116
  %117 = shl i64 %.713.sroa.0.3, 3
  %118 = add i64 %116, %117
  %scevgep34 = getelementptr i8, ptr %scevgep33, i64 %118
  %119 = shl i64 %.889.sroa.0.3, 3
  %120 = add i64 %116, %119
  %scevgep37 = getelementptr i8, ptr %scevgep36, i64 %120
  %scevgep41 = getelementptr i8, ptr %lsr.iv39, i64 %116
  %121 = mul i64 %61, %.1203
  %122 = add i64 %121, %116
  %scevgep43 = getelementptr i8, ptr %arg.p.4, i64 %122
  br label %vec.epilog.vector.body

vec.epilog.vector.body:                           ; preds = %vec.epilog.vector.body, %vec.epilog.ph
  %lsr.iv28 = phi i64 [ %lsr.iv.next, %vec.epilog.vector.body ], [ 0, %vec.epilog.ph ]
  %123 = shl i64 %lsr.iv28, 3
  %scevgep44 = getelementptr i8, ptr %scevgep43, i64 %123
  %wide.load206 = load <4 x double>, ptr %scevgep44, align 8, !alias.scope !421
  %124 = fneg <4 x double> %wide.load206
  %125 = shl i64 %lsr.iv28, 3
  %scevgep42 = getelementptr i8, ptr %scevgep41, i64 %125
  store <4 x double> %124, ptr %scevgep42, align 8, !alias.scope !424, !noalias !426
  %126 = shl i64 %lsr.iv28, 3
  %scevgep38 = getelementptr i8, ptr %scevgep37, i64 %126
  %wide.load207 = load <4 x double>, ptr %scevgep38, align 8, !alias.scope !430
  %127 = shl i64 %lsr.iv28, 3
  %scevgep35 = getelementptr i8, ptr %scevgep34, i64 %127
  %wide.load208 = load <4 x double>, ptr %scevgep35, align 8, !alias.scope !431
  %128 = fsub <4 x double> %wide.load208, %wide.load207
  %129 = fmul <4 x double> %broadcast.splat204, %128
  %130 = fadd <4 x double> %wide.load207, %129
  %131 = shl i64 %lsr.iv28, 3
  %scevgep32 = getelementptr i8, ptr %scevgep31, i64 %131
  store <4 x double> %130, ptr %scevgep32, align 8, !alias.scope !432, !noalias !433
  %lsr.iv.next = add i64 %lsr.iv28, 4
  %132 = icmp eq i64 %115, %lsr.iv.next
  br i1 %132, label %vec.epilog.middle.block, label %vec.epilog.vector.body, !llvm.loop !436

vec.epilog.middle.block:                          ; preds = %vec.epilog.vector.body
  %cmp.n210 = icmp eq i64 %.977, %n.vec202
  br i1 %cmp.n210, label %B594, label %B490.preheader

B490.preheader:                                   ; preds = %vec.epilog.middle.block, %vec.epilog.iter.check, %vector.memcheck, %iter.check
  %.1144841843.ph = phi i64 [ 0, %iter.check ], [ 0, %vector.memcheck ], [ %n.vec, %vec.epilog.iter.check ], [ %n.vec202, %vec.epilog.middle.block ]
  %133 = add i64 %.889.sroa.0.3, %.1144841843.ph
  %134 = sub i64 %.889.sroa.13.0, %133
  %xtraiter = and i64 %134, 7
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B490.prol.loopexit, label %B490.prol.preheader

B490.prol.preheader:                              ; preds = %B490.preheader
  %135 = shl i64 %.1144841843.ph, 3
  %scevgep45 = getelementptr i8, ptr %lsr.iv29, i64 %135
  %136 = shl i64 %.713.sroa.0.3, 3
  %137 = add i64 %135, %136
  %scevgep48 = getelementptr i8, ptr %scevgep47, i64 %137
  %138 = shl i64 %.889.sroa.0.3, 3
  %139 = add i64 %135, %138
  %scevgep51 = getelementptr i8, ptr %scevgep50, i64 %139
  %scevgep53 = getelementptr i8, ptr %lsr.iv39, i64 %135
  %140 = mul i64 %70, %.1203
  %141 = add i64 %140, %135
  %scevgep55 = getelementptr i8, ptr %arg.p.4, i64 %141
  br label %B490.prol

B490.prol:                                        ; preds = %B490.prol.preheader, %B490.prol
  %prol.iter = phi i64 [ %prol.iter.next, %B490.prol ], [ 0, %B490.prol.preheader ]
  %142 = shl nuw nsw i64 %prol.iter, 3
  %scevgep56 = getelementptr i8, ptr %scevgep55, i64 %142
  %.1228.prol = load double, ptr %scevgep56, align 8
  %.1231.prol = fneg double %.1228.prol
  %143 = shl nuw nsw i64 %prol.iter, 3
  %scevgep54 = getelementptr i8, ptr %scevgep53, i64 %143
  store double %.1231.prol, ptr %scevgep54, align 8
  %144 = shl nuw nsw i64 %prol.iter, 3
  %scevgep52 = getelementptr i8, ptr %scevgep51, i64 %144
  %.1316.prol = load double, ptr %scevgep52, align 8
  %145 = shl nuw nsw i64 %prol.iter, 3
  %scevgep49 = getelementptr i8, ptr %scevgep48, i64 %145
  %.1346.prol = load double, ptr %scevgep49, align 8
  %.1377.prol = fsub double %.1346.prol, %.1316.prol
  %.1379.prol = fmul double %arg.lag, %.1377.prol
  %.1380.prol = fadd double %.1316.prol, %.1379.prol
  %146 = shl nuw nsw i64 %prol.iter, 3
  %scevgep46 = getelementptr i8, ptr %scevgep45, i64 %146
  store double %.1380.prol, ptr %scevgep46, align 8
  %prol.iter.next = add nuw nsw i64 %prol.iter, 1
  %prol.iter.cmp.not = icmp eq i64 %xtraiter, %prol.iter.next
  br i1 %prol.iter.cmp.not, label %B490.prol.loopexit.loopexit, label %B490.prol, !llvm.loop !437

B490.prol.loopexit.loopexit:                      ; preds = %B490.prol
  %147 = add i64 %.1144841843.ph, %prol.iter.next
  br label %B490.prol.loopexit

B490.prol.loopexit:                               ; preds = %B490.prol.loopexit.loopexit, %B490.preheader
  %.1144841843.unr = phi i64 [ %.1144841843.ph, %B490.preheader ], [ %147, %B490.prol.loopexit.loopexit ]
  %148 = sub nsw i64 %.889.sroa.0.3, %.889.sroa.13.0
  %149 = add i64 %148, %.1144841843.ph
  %150 = icmp ugt i64 %149, -8
  br i1 %150, label %B594, label %B490.preheader6

B490.preheader6:                                  ; preds = %B490.prol.loopexit
  %151 = sub i64 %.889.sroa.13.0, %.889.sroa.0.3
  %152 = sub i64 %151, %.1144841843.unr
  %153 = shl i64 %.1144841843.unr, 3
  %scevgep62 = getelementptr i8, ptr %lsr.iv60, i64 %153
  %154 = shl i64 %.713.sroa.0.3, 3
  %155 = add i64 %153, %154
  %scevgep79 = getelementptr i8, ptr %scevgep78, i64 %155
  %156 = shl i64 %.889.sroa.0.3, 3
  %157 = add i64 %153, %156
  %scevgep96 = getelementptr i8, ptr %scevgep95, i64 %157
  %scevgep115 = getelementptr i8, ptr %lsr.iv113, i64 %153
  %158 = mul i64 %81, %.1203
  %159 = add i64 %158, %153
  %scevgep132 = getelementptr i8, ptr %scevgep131, i64 %159
  br label %B490

B596.endif.if:                                    ; preds = %B192.else.if.i
  store ptr @.const.picklebuf.dc3bba832c4c3758273d0db24b835691af3f316c.42, ptr %excinfo, align 8, !numba_exception_output !216
  br label %common.ret

B192.else.if.i104:                                ; preds = %B192.else.if.i
  %sunkaddr155 = getelementptr inbounds i8, ptr %.1499, i64 32
  %.1579 = load ptr, ptr %sunkaddr155, align 8
  %.1580.fca.0.load = load i64, ptr %.1503, align 8
  %.1581.fca.0.load = load i64, ptr %.1557, align 8
  %sunkaddr156 = getelementptr inbounds i8, ptr %.1499, i64 24
  %.1583 = load i64, ptr %sunkaddr156, align 8
  %.1585 = load ptr, ptr %.1499, align 8
  %sunkaddr157 = getelementptr inbounds i8, ptr %.1499, i64 8
  %.1587 = load ptr, ptr %sunkaddr157, align 8
  call void @NRT_incref(ptr %.1585)
  store ptr %.7.i.i.i.i59, ptr %.1627, align 8
  %sunkaddr158 = getelementptr inbounds i8, ptr %.1627, i64 8
  store ptr null, ptr %sunkaddr158, align 8
  %sunkaddr159 = getelementptr inbounds i8, ptr %.1627, i64 16
  store i64 %.51.i.i, ptr %sunkaddr159, align 8
  %sunkaddr160 = getelementptr inbounds i8, ptr %.1627, i64 24
  store i64 8, ptr %sunkaddr160, align 8
  %sunkaddr161 = getelementptr inbounds i8, ptr %.1627, i64 32
  store ptr %.6.i.i.i63, ptr %sunkaddr161, align 8
  %sunkaddr162 = getelementptr inbounds i8, ptr %.1627, i64 40
  store i64 %arg.some.2, ptr %sunkaddr162, align 8
  %sunkaddr163 = getelementptr inbounds i8, ptr %.1627, i64 48
  store i64 64, ptr %sunkaddr163, align 8
  %sunkaddr164 = getelementptr inbounds i8, ptr %.1627, i64 56
  store i64 512, ptr %sunkaddr164, align 8
  %sunkaddr165 = getelementptr inbounds i8, ptr %.1627, i64 64
  store i64 8, ptr %sunkaddr165, align 8
  store i64 %.51.i.i, ptr %.1631, align 8, !noalias !438
  %.1695 = call i32 @numba_attempt_nocopy_reshape(i64 2, ptr nonnull %.fca.5.0.gep, ptr nonnull %.fca.6.0.gep, i64 1, ptr nonnull %.1631, ptr nonnull %.1685, i64 8, i32 0)
  %.1696 = icmp eq i32 %.1695, 0
  call void @NRT_decref(ptr nonnull %.7.i.i.i.i)
  br i1 %.1696, label %B596.endif.endif.endif.if, label %B596.endif.endif.endif.endif

B596.endif.endif.endif.if:                        ; preds = %B192.else.if.i104
  store ptr @.const.picklebuf.dc3bba832c4c3758273d0db24b835691af3f316c.42, ptr %excinfo, align 8, !numba_exception_output !216
  br label %common.ret

B596.endif.endif.endif.endif:                     ; preds = %B192.else.if.i104
  %sunkaddr166 = getelementptr inbounds i8, ptr %.1627, i64 32
  %.1707 = load ptr, ptr %sunkaddr166, align 8
  %.1708.fca.0.load = load i64, ptr %.1631, align 8
  %.1709.fca.0.load = load i64, ptr %.1685, align 8
  %sunkaddr167 = getelementptr inbounds i8, ptr %.1627, i64 24
  %.1711 = load i64, ptr %sunkaddr167, align 8
  %.1713 = load ptr, ptr %.1627, align 8
  %sunkaddr168 = getelementptr inbounds i8, ptr %.1627, i64 8
  %.1715 = load ptr, ptr %sunkaddr168, align 8
  call void @NRT_incref(ptr %.1713)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.1741, i8 0, i64 24, i1 false)
  %.1749 = call i32 @_ZN18elastomer_friction7kernels5model8friction7weighedB3v65B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEv5ArrayIdLi1E1C7mutable7alignedEd(ptr nonnull %.1741, ptr nonnull %excinfo.7, ptr %.1585, ptr %.1587, i64 %.1580.fca.0.load, i64 %.1583, ptr %.1579, i64 %.1580.fca.0.load, i64 %.1581.fca.0.load, ptr null, ptr %.1713, ptr %.1715, i64 %.1708.fca.0.load, i64 %.1711, ptr %.1707, i64 %.1708.fca.0.load, i64 %.1709.fca.0.load, double 0.000000e+00)
  call void @NRT_decref(ptr nonnull %.7.i.i.i.i59)
  switch i32 %.1749, label %B596.endif.endif.endif.endif.if.if [
    i32 -2, label %B596.endif.endif.endif.endif.endif
    i32 0, label %B596.endif.endif.endif.endif.endif
  ], !prof !1

B596.endif.endif.endif.endif.endif:               ; preds = %B596.endif.endif.endif.endif, %B596.endif.endif.endif.endif
  %.1759.fca.0.load = load double, ptr %.1741, align 8
  %sunkaddr169 = getelementptr inbounds i8, ptr %.1741, i64 8
  %.1759.fca.1.load = load double, ptr %sunkaddr169, align 8
  %sunkaddr170 = getelementptr inbounds i8, ptr %.1741, i64 16
  %.1759.fca.2.load = load double, ptr %sunkaddr170, align 8
  call void @NRT_decref(ptr %.1713)
  call void @NRT_decref(ptr %.1585)
  store double %.1759.fca.0.load, ptr %retptr, align 8
  %retptr.repack835 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store double %.1759.fca.1.load, ptr %retptr.repack835, align 8
  %retptr.repack837 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store double %.1759.fca.2.load, ptr %retptr.repack837, align 8
  br label %common.ret

B596.endif.endif.endif.endif.if.if:               ; preds = %B596.endif.endif.endif.endif
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define linkonce_odr noundef i32 @_ZN18elastomer_friction7kernels5model8friction7weighedB3v65B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEv5ArrayIdLi1E1C7mutable7alignedEd(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.threshold.0, ptr readnone captures(none) %arg.threshold.1, i64 %arg.threshold.2, i64 %arg.threshold.3, ptr readonly captures(none) %arg.threshold.4, i64 %arg.threshold.5.0, i64 %arg.threshold.6.0, ptr readnone captures(none) %arg.covered, ptr readnone captures(none) %arg.slope.0, ptr readnone captures(none) %arg.slope.1, i64 %arg.slope.2, i64 %arg.slope.3, ptr readonly captures(none) %arg.slope.4, i64 %arg.slope.5.0, i64 %arg.slope.6.0, double %arg.d) local_unnamed_addr #9 {
B0.endif:
  %.13399.not = icmp slt i64 %arg.threshold.2, 1
  br i1 %.13399.not, label %B180, label %B58.preheader

B58.preheader:                                    ; preds = %B0.endif
  %xtraiter = and i64 %arg.threshold.2, 7
  %0 = icmp samesign ult i64 %arg.threshold.2, 8
  br i1 %0, label %B58.epil.preheader, label %B58.preheader.new

B58.preheader.new:                                ; preds = %B58.preheader
  %unroll_iter = and i64 %arg.threshold.2, 9223372036854775800
  br label %B58

B58:                                              ; preds = %B178.7, %B58.preheader.new
  %contact.2.0104 = phi double [ 0.000000e+00, %B58.preheader.new ], [ %contact.3.1.7, %B178.7 ]
  %tangential.2.0103 = phi double [ 0.000000e+00, %B58.preheader.new ], [ %tangential.3.1.7, %B178.7 ]
  %normal.2.0102 = phi double [ 0.000000e+00, %B58.preheader.new ], [ %normal.3.1.7, %B178.7 ]
  %.13998100 = phi i64 [ 0, %B58.preheader.new ], [ %.146.7, %B178.7 ]
  %sunkaddr = mul i64 %.13998100, 8
  %sunkaddr36 = getelementptr i8, ptr %arg.threshold.4, i64 %sunkaddr
  %.216 = load double, ptr %sunkaddr36, align 8
  %.218 = fsub double %arg.d, %.216
  %.223 = fcmp ogt double %.218, 0.000000e+00
  br i1 %.223, label %B116, label %B178

B116:                                             ; preds = %B58
  %.243 = fadd double %normal.2.0102, %.218
  %sunkaddr37 = mul i64 %.13998100, 8
  %sunkaddr38 = getelementptr i8, ptr %arg.slope.4, i64 %sunkaddr37
  %.282 = load double, ptr %sunkaddr38, align 8
  %.285 = fmul double %.218, %.282
  %.287 = fadd double %tangential.2.0103, %.285
  %.293 = fadd double %contact.2.0104, 1.000000e+00
  br label %B178

B178:                                             ; preds = %B116, %B58
  %normal.3.1 = phi double [ %.243, %B116 ], [ %normal.2.0102, %B58 ]
  %tangential.3.1 = phi double [ %.287, %B116 ], [ %tangential.2.0103, %B58 ]
  %contact.3.1 = phi double [ %.293, %B116 ], [ %contact.2.0104, %B58 ]
  %sunkaddr39 = mul i64 %.13998100, 8
  %sunkaddr40 = getelementptr i8, ptr %arg.threshold.4, i64 %sunkaddr39
  %sunkaddr41 = getelementptr i8, ptr %sunkaddr40, i64 8
  %.216.1 = load double, ptr %sunkaddr41, align 8
  %.218.1 = fsub double %arg.d, %.216.1
  %.223.1 = fcmp ogt double %.218.1, 0.000000e+00
  br i1 %.223.1, label %B116.1, label %B178.1

B116.1:                                           ; preds = %B178
  %.243.1 = fadd double %normal.3.1, %.218.1
  %sunkaddr42 = mul i64 %.13998100, 8
  %sunkaddr43 = getelementptr i8, ptr %arg.slope.4, i64 %sunkaddr42
  %sunkaddr44 = getelementptr i8, ptr %sunkaddr43, i64 8
  %.282.1 = load double, ptr %sunkaddr44, align 8
  %.285.1 = fmul double %.218.1, %.282.1
  %.287.1 = fadd double %tangential.3.1, %.285.1
  %.293.1 = fadd double %contact.3.1, 1.000000e+00
  br label %B178.1

B178.1:                                           ; preds = %B116.1, %B178
  %normal.3.1.1 = phi double [ %.243.1, %B116.1 ], [ %normal.3.1, %B178 ]
  %tangential.3.1.1 = phi double [ %.287.1, %B116.1 ], [ %tangential.3.1, %B178 ]
  %contact.3.1.1 = phi double [ %.293.1, %B116.1 ], [ %contact.3.1, %B178 ]
  %sunkaddr45 = mul i64 %.13998100, 8
  %sunkaddr46 = getelementptr i8, ptr %arg.threshold.4, i64 %sunkaddr45
  %sunkaddr47 = getelementptr i8, ptr %sunkaddr46, i64 16
  %.216.2 = load double, ptr %sunkaddr47, align 8
  %.218.2 = fsub double %arg.d, %.216.2
  %.223.2 = fcmp ogt double %.218.2, 0.000000e+00
  br i1 %.223.2, label %B116.2, label %B178.2

B116.2:                                           ; preds = %B178.1
  %.243.2 = fadd double %normal.3.1.1, %.218.2
  %sunkaddr48 = mul i64 %.13998100, 8
  %sunkaddr49 = getelementptr i8, ptr %arg.slope.4, i64 %sunkaddr48
  %sunkaddr50 = getelementptr i8, ptr %sunkaddr49, i64 16
  %.282.2 = load double, ptr %sunkaddr50, align 8
  %.285.2 = fmul double %.218.2, %.282.2
  %.287.2 = fadd double %tangential.3.1.1, %.285.2
  %.293.2 = fadd double %contact.3.1.1, 1.000000e+00
  br label %B178.2

B178.2:                                           ; preds = %B116.2, %B178.1
  %normal.3.1.2 = phi double [ %.243.2, %B116.2 ], [ %normal.3.1.1, %B178.1 ]
  %tangential.3.1.2 = phi double [ %.287.2, %B116.2 ], [ %tangential.3.1.1, %B178.1 ]
  %contact.3.1.2 = phi double [ %.293.2, %B116.2 ], [ %contact.3.1.1, %B178.1 ]
  %sunkaddr51 = mul i64 %.13998100, 8
  %sunkaddr52 = getelementptr i8, ptr %arg.threshold.4, i64 %sunkaddr51
  %sunkaddr53 = getelementptr i8, ptr %sunkaddr52, i64 24
  %.216.3 = load double, ptr %sunkaddr53, align 8
  %.218.3 = fsub double %arg.d, %.216.3
  %.223.3 = fcmp ogt double %.218.3, 0.000000e+00
  br i1 %.223.3, label %B116.3, label %B178.3

B116.3:                                           ; preds = %B178.2
  %.243.3 = fadd double %normal.3.1.2, %.218.3
  %sunkaddr54 = mul i64 %.13998100, 8
  %sunkaddr55 = getelementptr i8, ptr %arg.slope.4, i64 %sunkaddr54
  %sunkaddr56 = getelementptr i8, ptr %sunkaddr55, i64 24
  %.282.3 = load double, ptr %sunkaddr56, align 8
  %.285.3 = fmul double %.218.3, %.282.3
  %.287.3 = fadd double %tangential.3.1.2, %.285.3
  %.293.3 = fadd double %contact.3.1.2, 1.000000e+00
  br label %B178.3

B178.3:                                           ; preds = %B116.3, %B178.2
  %normal.3.1.3 = phi double [ %.243.3, %B116.3 ], [ %normal.3.1.2, %B178.2 ]
  %tangential.3.1.3 = phi double [ %.287.3, %B116.3 ], [ %tangential.3.1.2, %B178.2 ]
  %contact.3.1.3 = phi double [ %.293.3, %B116.3 ], [ %contact.3.1.2, %B178.2 ]
  %sunkaddr57 = mul i64 %.13998100, 8
  %sunkaddr58 = getelementptr i8, ptr %arg.threshold.4, i64 %sunkaddr57
  %sunkaddr59 = getelementptr i8, ptr %sunkaddr58, i64 32
  %.216.4 = load double, ptr %sunkaddr59, align 8
  %.218.4 = fsub double %arg.d, %.216.4
  %.223.4 = fcmp ogt double %.218.4, 0.000000e+00
  br i1 %.223.4, label %B116.4, label %B178.4

B116.4:                                           ; preds = %B178.3
  %.243.4 = fadd double %normal.3.1.3, %.218.4
  %sunkaddr60 = mul i64 %.13998100, 8
  %sunkaddr61 = getelementptr i8, ptr %arg.slope.4, i64 %sunkaddr60
  %sunkaddr62 = getelementptr i8, ptr %sunkaddr61, i64 32
  %.282.4 = load double, ptr %sunkaddr62, align 8
  %.285.4 = fmul double %.218.4, %.282.4
  %.287.4 = fadd double %tangential.3.1.3, %.285.4
  %.293.4 = fadd double %contact.3.1.3, 1.000000e+00
  br label %B178.4

B178.4:                                           ; preds = %B116.4, %B178.3
  %normal.3.1.4 = phi double [ %.243.4, %B116.4 ], [ %normal.3.1.3, %B178.3 ]
  %tangential.3.1.4 = phi double [ %.287.4, %B116.4 ], [ %tangential.3.1.3, %B178.3 ]
  %contact.3.1.4 = phi double [ %.293.4, %B116.4 ], [ %contact.3.1.3, %B178.3 ]
  %sunkaddr63 = mul i64 %.13998100, 8
  %sunkaddr64 = getelementptr i8, ptr %arg.threshold.4, i64 %sunkaddr63
  %sunkaddr65 = getelementptr i8, ptr %sunkaddr64, i64 40
  %.216.5 = load double, ptr %sunkaddr65, align 8
  %.218.5 = fsub double %arg.d, %.216.5
  %.223.5 = fcmp ogt double %.218.5, 0.000000e+00
  br i1 %.223.5, label %B116.5, label %B178.5

B116.5:                                           ; preds = %B178.4
  %.243.5 = fadd double %normal.3.1.4, %.218.5
  %sunkaddr66 = mul i64 %.13998100, 8
  %sunkaddr67 = getelementptr i8, ptr %arg.slope.4, i64 %sunkaddr66
  %sunkaddr68 = getelementptr i8, ptr %sunkaddr67, i64 40
  %.282.5 = load double, ptr %sunkaddr68, align 8
  %.285.5 = fmul double %.218.5, %.282.5
  %.287.5 = fadd double %tangential.3.1.4, %.285.5
  %.293.5 = fadd double %contact.3.1.4, 1.000000e+00
  br label %B178.5

B178.5:                                           ; preds = %B116.5, %B178.4
  %normal.3.1.5 = phi double [ %.243.5, %B116.5 ], [ %normal.3.1.4, %B178.4 ]
  %tangential.3.1.5 = phi double [ %.287.5, %B116.5 ], [ %tangential.3.1.4, %B178.4 ]
  %contact.3.1.5 = phi double [ %.293.5, %B116.5 ], [ %contact.3.1.4, %B178.4 ]
  %sunkaddr69 = mul i64 %.13998100, 8
  %sunkaddr70 = getelementptr i8, ptr %arg.threshold.4, i64 %sunkaddr69
  %sunkaddr71 = getelementptr i8, ptr %sunkaddr70, i64 48
  %.216.6 = load double, ptr %sunkaddr71, align 8
  %.218.6 = fsub double %arg.d, %.216.6
  %.223.6 = fcmp ogt double %.218.6, 0.000000e+00
  br i1 %.223.6, label %B116.6, label %B178.6

B116.6:                                           ; preds = %B178.5
  %.243.6 = fadd double %normal.3.1.5, %.218.6
  %sunkaddr72 = mul i64 %.13998100, 8
  %sunkaddr73 = getelementptr i8, ptr %arg.slope.4, i64 %sunkaddr72
  %sunkaddr74 = getelementptr i8, ptr %sunkaddr73, i64 48
  %.282.6 = load double, ptr %sunkaddr74, align 8
  %.285.6 = fmul double %.218.6, %.282.6
  %.287.6 = fadd double %tangential.3.1.5, %.285.6
  %.293.6 = fadd double %contact.3.1.5, 1.000000e+00
  br label %B178.6

B178.6:                                           ; preds = %B116.6, %B178.5
  %normal.3.1.6 = phi double [ %.243.6, %B116.6 ], [ %normal.3.1.5, %B178.5 ]
  %tangential.3.1.6 = phi double [ %.287.6, %B116.6 ], [ %tangential.3.1.5, %B178.5 ]
  %contact.3.1.6 = phi double [ %.293.6, %B116.6 ], [ %contact.3.1.5, %B178.5 ]
  %.146.7 = add nuw nsw i64 %.13998100, 8
  %sunkaddr75 = mul i64 %.13998100, 8
  %sunkaddr76 = getelementptr i8, ptr %arg.threshold.4, i64 %sunkaddr75
  %sunkaddr77 = getelementptr i8, ptr %sunkaddr76, i64 56
  %.216.7 = load double, ptr %sunkaddr77, align 8
  %.218.7 = fsub double %arg.d, %.216.7
  %.223.7 = fcmp ogt double %.218.7, 0.000000e+00
  br i1 %.223.7, label %B116.7, label %B178.7

B116.7:                                           ; preds = %B178.6
  %.243.7 = fadd double %normal.3.1.6, %.218.7
  %sunkaddr78 = mul i64 %.13998100, 8
  %sunkaddr79 = getelementptr i8, ptr %arg.slope.4, i64 %sunkaddr78
  %sunkaddr80 = getelementptr i8, ptr %sunkaddr79, i64 56
  %.282.7 = load double, ptr %sunkaddr80, align 8
  %.285.7 = fmul double %.218.7, %.282.7
  %.287.7 = fadd double %tangential.3.1.6, %.285.7
  %.293.7 = fadd double %contact.3.1.6, 1.000000e+00
  br label %B178.7

B178.7:                                           ; preds = %B116.7, %B178.6
  %normal.3.1.7 = phi double [ %.243.7, %B116.7 ], [ %normal.3.1.6, %B178.6 ]
  %tangential.3.1.7 = phi double [ %.287.7, %B116.7 ], [ %tangential.3.1.6, %B178.6 ]
  %contact.3.1.7 = phi double [ %.293.7, %B116.7 ], [ %contact.3.1.6, %B178.6 ]
  %niter.ncmp.7 = icmp eq i64 %unroll_iter, %.146.7
  br i1 %niter.ncmp.7, label %B180.loopexit.unr-lcssa, label %B58

B180.loopexit.unr-lcssa:                          ; preds = %B178.7
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B180, label %B58.epil.preheader

B58.epil.preheader:                               ; preds = %B180.loopexit.unr-lcssa, %B58.preheader
  %contact.2.0104.epil.init = phi double [ 0.000000e+00, %B58.preheader ], [ %contact.3.1.7, %B180.loopexit.unr-lcssa ]
  %tangential.2.0103.epil.init = phi double [ 0.000000e+00, %B58.preheader ], [ %tangential.3.1.7, %B180.loopexit.unr-lcssa ]
  %normal.2.0102.epil.init = phi double [ 0.000000e+00, %B58.preheader ], [ %normal.3.1.7, %B180.loopexit.unr-lcssa ]
  %.13998100.epil.init = phi i64 [ 0, %B58.preheader ], [ %unroll_iter, %B180.loopexit.unr-lcssa ]
  %1 = shl i64 %.13998100.epil.init, 3
  %scevgep = getelementptr i8, ptr %arg.slope.4, i64 %1
  %scevgep2 = getelementptr i8, ptr %arg.threshold.4, i64 %1
  br label %B58.epil

B58.epil:                                         ; preds = %B178.epil, %B58.epil.preheader
  %contact.2.0104.epil = phi double [ %contact.3.1.epil, %B178.epil ], [ %contact.2.0104.epil.init, %B58.epil.preheader ]
  %tangential.2.0103.epil = phi double [ %tangential.3.1.epil, %B178.epil ], [ %tangential.2.0103.epil.init, %B58.epil.preheader ]
  %normal.2.0102.epil = phi double [ %normal.3.1.epil, %B178.epil ], [ %normal.2.0102.epil.init, %B58.epil.preheader ]
  %epil.iter = phi i64 [ %epil.iter.next, %B178.epil ], [ 0, %B58.epil.preheader ]
  %2 = shl nuw nsw i64 %epil.iter, 3
  %scevgep3 = getelementptr i8, ptr %scevgep2, i64 %2
  %.216.epil = load double, ptr %scevgep3, align 8
  %.218.epil = fsub double %arg.d, %.216.epil
  %.223.epil = fcmp ogt double %.218.epil, 0.000000e+00
  br i1 %.223.epil, label %B116.epil, label %B178.epil

B116.epil:                                        ; preds = %B58.epil
  %.243.epil = fadd double %normal.2.0102.epil, %.218.epil
  %3 = shl nuw nsw i64 %epil.iter, 3
  %scevgep1 = getelementptr i8, ptr %scevgep, i64 %3
  %.282.epil = load double, ptr %scevgep1, align 8
  %.285.epil = fmul double %.218.epil, %.282.epil
  %.287.epil = fadd double %tangential.2.0103.epil, %.285.epil
  %.293.epil = fadd double %contact.2.0104.epil, 1.000000e+00
  br label %B178.epil

B178.epil:                                        ; preds = %B116.epil, %B58.epil
  %normal.3.1.epil = phi double [ %.243.epil, %B116.epil ], [ %normal.2.0102.epil, %B58.epil ]
  %tangential.3.1.epil = phi double [ %.287.epil, %B116.epil ], [ %tangential.2.0103.epil, %B58.epil ]
  %contact.3.1.epil = phi double [ %.293.epil, %B116.epil ], [ %contact.2.0104.epil, %B58.epil ]
  %epil.iter.next = add nuw nsw i64 %epil.iter, 1
  %epil.iter.cmp.not = icmp eq i64 %xtraiter, %epil.iter.next
  br i1 %epil.iter.cmp.not, label %B180, label %B58.epil, !llvm.loop !442

B180:                                             ; preds = %B178.epil, %B180.loopexit.unr-lcssa, %B0.endif
  %normal.2.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %normal.3.1.7, %B180.loopexit.unr-lcssa ], [ %normal.3.1.epil, %B178.epil ]
  %tangential.2.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %tangential.3.1.7, %B180.loopexit.unr-lcssa ], [ %tangential.3.1.epil, %B178.epil ]
  %contact.2.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %contact.3.1.7, %B180.loopexit.unr-lcssa ], [ %contact.3.1.epil, %B178.epil ]
  store double %normal.2.0.lcssa, ptr %retptr, align 8
  %retptr.repack93 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store double %tangential.2.0.lcssa, ptr %retptr.repack93, align 8
  %retptr.repack95 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store double %contact.2.0.lcssa, ptr %retptr.repack95, align 8
  ret i32 0
}

define linkonce_odr range(i32 -1, -2) i32 @_ZN18elastomer_friction7kernels5scene12march_blocks15_count_as_it_isB3v69B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE368ElementBlocks_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_29x(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, ptr %arg.blocks.0.0, ptr readnone captures(none) %arg.blocks.0.1, i64 %arg.blocks.0.2, i64 %arg.blocks.0.3, ptr captures(none) %arg.blocks.0.4, i64 %arg.blocks.0.5.0, i64 %arg.blocks.0.5.1, i64 %arg.blocks.0.5.2, i64 %arg.blocks.0.6.0, i64 %arg.blocks.0.6.1, i64 %arg.blocks.0.6.2, ptr %arg.blocks.1.0, ptr readnone captures(none) %arg.blocks.1.1, i64 %arg.blocks.1.2, i64 %arg.blocks.1.3, ptr captures(none) %arg.blocks.1.4, i64 %arg.blocks.1.5.0, i64 %arg.blocks.1.6.0, ptr readnone captures(none) %arg.blocks.2.0, ptr readnone captures(none) %arg.blocks.2.1, i64 %arg.blocks.2.2, i64 %arg.blocks.2.3, ptr readnone captures(none) %arg.blocks.2.4, i64 %arg.blocks.2.5.0, i64 %arg.blocks.2.6.0, ptr %arg.blocks.3.0.0, ptr readnone captures(none) %arg.blocks.3.0.1, i64 %arg.blocks.3.0.2, i64 %arg.blocks.3.0.3, ptr captures(none) %arg.blocks.3.0.4, i64 %arg.blocks.3.0.5.0, i64 %arg.blocks.3.0.6.0, ptr %arg.blocks.3.1.0, ptr readnone captures(none) %arg.blocks.3.1.1, i64 %arg.blocks.3.1.2, i64 %arg.blocks.3.1.3, ptr readonly captures(none) %arg.blocks.3.1.4, i64 %arg.blocks.3.1.5.0, i64 %arg.blocks.3.1.6.0, ptr %arg.blocks.3.2.0, ptr readnone captures(none) %arg.blocks.3.2.1, i64 %arg.blocks.3.2.2, i64 %arg.blocks.3.2.3, ptr readonly captures(none) %arg.blocks.3.2.4, i64 %arg.blocks.3.2.5.0, i64 %arg.blocks.3.2.6.0, ptr %arg.blocks.3.3.0, ptr readnone captures(none) %arg.blocks.3.3.1, i64 %arg.blocks.3.3.2, i64 %arg.blocks.3.3.3, ptr readnone captures(none) %arg.blocks.3.3.4, i64 %arg.blocks.3.3.5.0, i64 %arg.blocks.3.3.6.0, ptr %arg.blocks.3.4.0, ptr readnone captures(none) %arg.blocks.3.4.1, i64 %arg.blocks.3.4.2, i64 %arg.blocks.3.4.3, ptr readnone captures(none) %arg.blocks.3.4.4, i64 %arg.blocks.3.4.5.0, i64 %arg.blocks.3.4.6.0, ptr %arg.blocks.3.5.0, ptr readnone captures(none) %arg.blocks.3.5.1, i64 %arg.blocks.3.5.2, i64 %arg.blocks.3.5.3, ptr readnone captures(none) %arg.blocks.3.5.4, i64 %arg.blocks.3.5.5.0, i64 %arg.blocks.3.5.6.0, i64 %arg.step) local_unnamed_addr {
B0:
  %arg.blocks.3.0.2.fr = freeze i64 %arg.blocks.3.0.2
  %.395 = alloca ptr, align 8
  %excinfo.2 = alloca ptr, align 8
  tail call void @NRT_incref(ptr %arg.blocks.0.0)
  tail call void @NRT_incref(ptr %arg.blocks.1.0)
  tail call void @NRT_incref(ptr %arg.blocks.3.0.0)
  tail call void @NRT_incref(ptr %arg.blocks.3.1.0)
  tail call void @NRT_incref(ptr %arg.blocks.3.2.0)
  tail call void @NRT_incref(ptr %arg.blocks.3.3.0)
  tail call void @NRT_incref(ptr %arg.blocks.3.4.0)
  tail call void @NRT_incref(ptr %arg.blocks.3.5.0)
  %.104.i = sitofp i64 %arg.blocks.1.2 to double
  %.111.i = fptosi double %.104.i to i64
  %.13.i.i = tail call i64 @llvm.smax.i64(i64 %.111.i, i64 0)
  %.31.i.i = icmp sgt i64 %.111.i, 1152921504606846975
  br i1 %.31.i.i, label %B0.if.if, label %B0.endif.endif.endif.i.i, !prof !11

B0.endif.endif.endif.i.i:                         ; preds = %B0
  %.30.i.i = shl nuw nsw i64 %.13.i.i, 3
  %.7.i.i.i.i = tail call ptr @NRT_MemInfo_alloc_aligned(i64 %.30.i.i, i32 32), !noalias !443
  %.8.i.i.i.i = icmp eq ptr %.7.i.i.i.i, null
  br i1 %.8.i.i.i.i, label %B0.if.if, label %B388.endif.endif.i, !prof !11

B466.i:                                           ; preds = %B466.i.preheader, %B466.i
  %.311120122.i = phi i64 [ %.318.i, %B466.i ], [ %.311120122.i.ph, %B466.i.preheader ]
  %.318.i = add nuw nsw i64 %.311120122.i, 1
  %0 = shl i64 %.311120122.i, 3
  %scevgep.i = getelementptr i8, ptr %.6.i.i.i, i64 %0
  store i64 %.311120122.i, ptr %scevgep.i, align 8, !noalias !456
  %exitcond.not.i = icmp eq i64 %.111.i, %.318.i
  br i1 %exitcond.not.i, label %B0.endif, label %B466.i, !llvm.loop !457

B388.endif.endif.i:                               ; preds = %B0.endif.endif.endif.i.i
  %.5.i.i.i = getelementptr i8, ptr %.7.i.i.i.i, i64 24
  %.6.i.i.i = load ptr, ptr %.5.i.i.i, align 8, !noalias !458
  %.305121.not.i = icmp slt i64 %.111.i, 1
  br i1 %.305121.not.i, label %B0.endif, label %iter.check.i

iter.check.i:                                     ; preds = %B388.endif.endif.i
  %min.iters.check.i = icmp samesign ult i64 %.111.i, 4
  br i1 %min.iters.check.i, label %B466.i.preheader, label %vector.main.loop.iter.check.i

B466.i.preheader:                                 ; preds = %vec.epilog.middle.block.i, %vec.epilog.iter.check.i, %iter.check.i
  %.311120122.i.ph = phi i64 [ 0, %iter.check.i ], [ %n.vec.i, %vec.epilog.iter.check.i ], [ %n.vec13.i, %vec.epilog.middle.block.i ]
  br label %B466.i

vector.main.loop.iter.check.i:                    ; preds = %iter.check.i
  %const = bitcast i64 9223372036854775776 to i64
  %min.iters.check11.i = icmp samesign ult i64 %.111.i, 32
  br i1 %min.iters.check11.i, label %vec.epilog.ph.i, label %vector.ph.i

vector.ph.i:                                      ; preds = %vector.main.loop.iter.check.i
  %n.vec.i = and i64 %.111.i, %const
  br label %vector.body.i

vector.body.i:                                    ; preds = %vector.body.i, %vector.ph.i
  %index.i = phi i64 [ 0, %vector.ph.i ], [ %index.next.i, %vector.body.i ]
  %vec.ind.i = phi <8 x i64> [ <i64 0, i64 1, i64 2, i64 3, i64 4, i64 5, i64 6, i64 7>, %vector.ph.i ], [ %vec.ind.next.i, %vector.body.i ]
  %step.add.i = add <8 x i64> %vec.ind.i, splat (i64 8)
  %step.add.2.i = add <8 x i64> %vec.ind.i, splat (i64 16)
  %step.add.3.i = add <8 x i64> %vec.ind.i, splat (i64 24)
  %sunkaddr = mul i64 %index.i, 8
  %sunkaddr29 = getelementptr i8, ptr %.6.i.i.i, i64 %sunkaddr
  store <8 x i64> %vec.ind.i, ptr %sunkaddr29, align 8, !noalias !456
  %sunkaddr30 = mul i64 %index.i, 8
  %sunkaddr31 = getelementptr i8, ptr %.6.i.i.i, i64 %sunkaddr30
  %sunkaddr32 = getelementptr i8, ptr %sunkaddr31, i64 64
  store <8 x i64> %step.add.i, ptr %sunkaddr32, align 8, !noalias !456
  %sunkaddr33 = mul i64 %index.i, 8
  %sunkaddr34 = getelementptr i8, ptr %.6.i.i.i, i64 %sunkaddr33
  %sunkaddr35 = getelementptr i8, ptr %sunkaddr34, i64 128
  store <8 x i64> %step.add.2.i, ptr %sunkaddr35, align 8, !noalias !456
  %sunkaddr36 = mul i64 %index.i, 8
  %sunkaddr37 = getelementptr i8, ptr %.6.i.i.i, i64 %sunkaddr36
  %sunkaddr38 = getelementptr i8, ptr %sunkaddr37, i64 192
  store <8 x i64> %step.add.3.i, ptr %sunkaddr38, align 8, !noalias !456
  %index.next.i = add nuw nsw i64 %index.i, 32
  %vec.ind.next.i = add <8 x i64> %vec.ind.i, splat (i64 32)
  %1 = icmp eq i64 %n.vec.i, %index.next.i
  br i1 %1, label %middle.block.i, label %vector.body.i, !llvm.loop !459

middle.block.i:                                   ; preds = %vector.body.i
  %cmp.n.i = icmp eq i64 %n.vec.i, %.111.i
  br i1 %cmp.n.i, label %B0.endif, label %vec.epilog.iter.check.i

vec.epilog.iter.check.i:                          ; preds = %middle.block.i
  %2 = and i64 %.111.i, 28
  %min.epilog.iters.check.i = icmp eq i64 %2, 0
  br i1 %min.epilog.iters.check.i, label %B466.i.preheader, label %vec.epilog.ph.i, !prof !91

vec.epilog.ph.i:                                  ; preds = %vec.epilog.iter.check.i, %vector.main.loop.iter.check.i
  %bc.resume.val.i = phi i64 [ %n.vec.i, %vec.epilog.iter.check.i ], [ 0, %vector.main.loop.iter.check.i ]
  %const_mat = add i64 %const, 28
  %n.vec13.i = and i64 %.111.i, %const_mat
  %broadcast.splatinsert.i = insertelement <4 x i64> poison, i64 %bc.resume.val.i, i64 0
  %broadcast.splat.i = shufflevector <4 x i64> %broadcast.splatinsert.i, <4 x i64> poison, <4 x i32> zeroinitializer
  %induction.i = or disjoint <4 x i64> %broadcast.splat.i, <i64 0, i64 1, i64 2, i64 3>
  br label %vec.epilog.vector.body.i

vec.epilog.vector.body.i:                         ; preds = %vec.epilog.vector.body.i, %vec.epilog.ph.i
  %index14.i = phi i64 [ %bc.resume.val.i, %vec.epilog.ph.i ], [ %index.next16.i, %vec.epilog.vector.body.i ]
  %vec.ind15.i = phi <4 x i64> [ %induction.i, %vec.epilog.ph.i ], [ %vec.ind.next17.i, %vec.epilog.vector.body.i ]
  %3 = shl i64 %index14.i, 3
  %scevgep20.i = getelementptr i8, ptr %.6.i.i.i, i64 %3
  store <4 x i64> %vec.ind15.i, ptr %scevgep20.i, align 8, !noalias !456
  %index.next16.i = add nuw i64 %index14.i, 4
  %vec.ind.next17.i = add nuw nsw <4 x i64> %vec.ind15.i, splat (i64 4)
  %4 = icmp eq i64 %n.vec13.i, %index.next16.i
  br i1 %4, label %vec.epilog.middle.block.i, label %vec.epilog.vector.body.i, !llvm.loop !460

vec.epilog.middle.block.i:                        ; preds = %vec.epilog.vector.body.i
  %cmp.n18.i = icmp eq i64 %n.vec13.i, %.111.i
  br i1 %cmp.n18.i, label %B0.endif, label %B466.i.preheader

B424:                                             ; preds = %B424.preheader, %B424
  %.1179552554 = phi i64 [ %.1186, %B424 ], [ %.1179552554.ph, %B424.preheader ]
  %.1186 = add nuw nsw i64 %.1179552554, 1
  %5 = shl i64 %.1179552554, 3
  %scevgep = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %5
  store double 1.000000e+00, ptr %scevgep, align 8
  %exitcond561.not = icmp eq i64 %arg.blocks.3.0.2.fr, %.1186
  br i1 %exitcond561.not, label %B448, label %B424, !llvm.loop !461

common.ret:                                       ; preds = %B0.endif.if.if, %B0.if.if, %B448
  %common.ret.op = phi i32 [ 0, %B448 ], [ 1, %B0.if.if ], [ %.421, %B0.endif.if.if ]
  ret i32 %common.ret.op

B448:                                             ; preds = %B424, %vec.epilog.middle.block, %middle.block26, %B372.endif, %B144.endif.preheader
  tail call void @NRT_decref(ptr %arg.blocks.3.0.0)
  tail call void @NRT_decref(ptr %arg.blocks.3.1.0)
  tail call void @NRT_decref(ptr %arg.blocks.3.2.0)
  tail call void @NRT_decref(ptr %arg.blocks.3.3.0)
  tail call void @NRT_decref(ptr %arg.blocks.3.4.0)
  tail call void @NRT_decref(ptr %arg.blocks.3.5.0)
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B0.endif:                                         ; preds = %B466.i, %vec.epilog.middle.block.i, %middle.block.i, %B388.endif.endif.i
  %.421 = call i32 @_ZN18elastomer_friction7kernels8rheology6scaled8catch_upB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx(ptr nonnull %.395, ptr nonnull %excinfo.2, ptr %arg.blocks.3.0.0, ptr %arg.blocks.3.0.1, i64 %arg.blocks.3.0.2.fr, i64 %arg.blocks.3.0.3, ptr %arg.blocks.3.0.4, i64 %arg.blocks.3.0.5.0, i64 %arg.blocks.3.0.6.0, ptr %arg.blocks.3.1.0, ptr %arg.blocks.3.1.1, i64 %arg.blocks.3.1.2, i64 %arg.blocks.3.1.3, ptr %arg.blocks.3.1.4, i64 %arg.blocks.3.1.5.0, i64 %arg.blocks.3.1.6.0, ptr %arg.blocks.3.2.0, ptr %arg.blocks.3.2.1, i64 %arg.blocks.3.2.2, i64 %arg.blocks.3.2.3, ptr %arg.blocks.3.2.4, i64 %arg.blocks.3.2.5.0, i64 %arg.blocks.3.2.6.0, ptr %arg.blocks.3.3.0, ptr %arg.blocks.3.3.1, i64 %arg.blocks.3.3.2, i64 %arg.blocks.3.3.3, ptr %arg.blocks.3.3.4, i64 %arg.blocks.3.3.5.0, i64 %arg.blocks.3.3.6.0, ptr %arg.blocks.3.4.0, ptr %arg.blocks.3.4.1, i64 %arg.blocks.3.4.2, i64 %arg.blocks.3.4.3, ptr %arg.blocks.3.4.4, i64 %arg.blocks.3.4.5.0, i64 %arg.blocks.3.4.6.0, ptr %arg.blocks.3.5.0, ptr %arg.blocks.3.5.1, i64 %arg.blocks.3.5.2, i64 %arg.blocks.3.5.3, ptr %arg.blocks.3.5.4, i64 %arg.blocks.3.5.5.0, i64 %arg.blocks.3.5.6.0, ptr %arg.blocks.0.0, ptr %arg.blocks.0.1, i64 %arg.blocks.0.2, i64 %arg.blocks.0.3, ptr %arg.blocks.0.4, i64 %arg.blocks.0.5.0, i64 %arg.blocks.0.5.1, i64 %arg.blocks.0.5.2, i64 %arg.blocks.0.6.0, i64 %arg.blocks.0.6.1, i64 %arg.blocks.0.6.2, ptr %arg.blocks.1.0, ptr %arg.blocks.1.1, i64 %arg.blocks.1.2, i64 %arg.blocks.1.3, ptr %arg.blocks.1.4, i64 %arg.blocks.1.5.0, i64 %arg.blocks.1.6.0, ptr nonnull %.7.i.i.i.i, ptr null, i64 %.13.i.i, i64 8, ptr %.6.i.i.i, i64 %.13.i.i, i64 8, i64 %arg.step)
  %cond = icmp eq i32 %.421, 0
  br i1 %cond, label %B0.endif.endif.endif, label %B0.endif.if.if, !prof !0

B0.if.if:                                         ; preds = %B0.endif.endif.endif.i.i, %B0
  %excinfo.1.0 = phi ptr [ @.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209.53, %B0.endif.endif.endif.i.i ], [ @.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57.54, %B0 ]
  store ptr %excinfo.1.0, ptr %excinfo, align 8
  br label %common.ret

B0.endif.if.if:                                   ; preds = %B0.endif
  store ptr null, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif:                             ; preds = %B0.endif
  tail call void @NRT_decref(ptr nonnull %.7.i.i.i.i)
  tail call void @NRT_decref(ptr %arg.blocks.1.0)
  %.532535.not = icmp slt i64 %arg.blocks.1.2, 1
  br i1 %.532535.not, label %B372.endif, label %B144.endif.lr.ph

B144.endif.lr.ph:                                 ; preds = %B0.endif.endif.endif
  %.666517 = icmp sgt i64 %arg.blocks.3.0.2.fr, 0
  br i1 %.666517, label %B144.endif.us.preheader, label %B144.endif.preheader

B144.endif.us.preheader:                          ; preds = %B144.endif.lr.ph
  %scevgep7 = getelementptr i8, ptr %arg.blocks.0.4, i64 448
  %6 = mul i64 %arg.blocks.0.5.2, %arg.blocks.0.5.1
  %7 = shl i64 %6, 3
  %8 = shl i64 %arg.blocks.0.5.2, 3
  br label %B144.endif.us

B144.endif.preheader:                             ; preds = %B144.endif.lr.ph
  tail call void @NRT_decref(ptr %arg.blocks.0.0)
  br label %B448

B144.endif.us:                                    ; preds = %B144.endif.us.preheader, %B196.B142.loopexit_crit_edge.split.us.us
  %lsr.iv = phi ptr [ %scevgep7, %B144.endif.us.preheader ], [ %scevgep8, %B196.B142.loopexit_crit_edge.split.us.us ]
  %.538528538.us = phi i64 [ %.545.us, %B196.B142.loopexit_crit_edge.split.us.us ], [ 0, %B144.endif.us.preheader ]
  br label %B198.endif.endif.us.us

B198.endif.endif.us.us:                           ; preds = %B198.endif.endif.us.us, %B144.endif.us
  %lsr.iv9 = phi ptr [ %scevgep10, %B198.endif.endif.us.us ], [ %lsr.iv, %B144.endif.us ]
  %.672512518.us.us = phi i64 [ 0, %B144.endif.us ], [ %.679.us.us, %B198.endif.endif.us.us ]
  %9 = shl i64 %.672512518.us.us, 3
  %scevgep18 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %9
  %.741.us.us = load double, ptr %scevgep18, align 8
  %broadcast.splatinsert = insertelement <8 x double> poison, double %.741.us.us, i64 0
  %broadcast.splat = shufflevector <8 x double> %broadcast.splatinsert, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep14 = getelementptr i8, ptr %lsr.iv9, i64 -448
  %scevgep17 = getelementptr i8, ptr %lsr.iv9, i64 -384
  %scevgep16 = getelementptr i8, ptr %lsr.iv9, i64 -320
  %scevgep15 = getelementptr i8, ptr %lsr.iv9, i64 -256
  %wide.load = load <8 x double>, ptr %scevgep14, align 8
  %wide.load17 = load <8 x double>, ptr %scevgep17, align 8
  %wide.load18 = load <8 x double>, ptr %scevgep16, align 8
  %wide.load19 = load <8 x double>, ptr %scevgep15, align 8
  %10 = fmul <8 x double> %wide.load, %broadcast.splat
  %11 = fmul <8 x double> %broadcast.splat, %wide.load17
  %12 = fmul <8 x double> %broadcast.splat, %wide.load18
  %13 = fmul <8 x double> %broadcast.splat, %wide.load19
  %14 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %10)
  %15 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %11)
  %16 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %12)
  %17 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %13)
  %18 = fcmp ogt <8 x double> %14, splat (double 0x16687E92154EF7AC)
  %19 = fcmp ogt <8 x double> %15, splat (double 0x16687E92154EF7AC)
  %20 = fcmp ogt <8 x double> %16, splat (double 0x16687E92154EF7AC)
  %21 = fcmp ogt <8 x double> %17, splat (double 0x16687E92154EF7AC)
  %22 = select <8 x i1> %18, <8 x double> %10, <8 x double> zeroinitializer
  %23 = select <8 x i1> %19, <8 x double> %11, <8 x double> zeroinitializer
  %24 = select <8 x i1> %20, <8 x double> %12, <8 x double> zeroinitializer
  %25 = select <8 x i1> %21, <8 x double> %13, <8 x double> zeroinitializer
  store <8 x double> %22, ptr %scevgep14, align 8
  store <8 x double> %23, ptr %scevgep17, align 8
  store <8 x double> %24, ptr %scevgep16, align 8
  store <8 x double> %25, ptr %scevgep15, align 8
  %scevgep13 = getelementptr i8, ptr %lsr.iv9, i64 -192
  %scevgep12 = getelementptr i8, ptr %lsr.iv9, i64 -128
  %scevgep11 = getelementptr i8, ptr %lsr.iv9, i64 -64
  %wide.load.1 = load <8 x double>, ptr %scevgep13, align 8
  %wide.load17.1 = load <8 x double>, ptr %scevgep12, align 8
  %wide.load18.1 = load <8 x double>, ptr %scevgep11, align 8
  %wide.load19.1 = load <8 x double>, ptr %lsr.iv9, align 8
  %26 = fmul <8 x double> %broadcast.splat, %wide.load.1
  %27 = fmul <8 x double> %broadcast.splat, %wide.load17.1
  %28 = fmul <8 x double> %broadcast.splat, %wide.load18.1
  %29 = fmul <8 x double> %broadcast.splat, %wide.load19.1
  %30 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %26)
  %31 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %27)
  %32 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %28)
  %33 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %29)
  %34 = fcmp ogt <8 x double> %30, splat (double 0x16687E92154EF7AC)
  %35 = fcmp ogt <8 x double> %31, splat (double 0x16687E92154EF7AC)
  %36 = fcmp ogt <8 x double> %32, splat (double 0x16687E92154EF7AC)
  %37 = fcmp ogt <8 x double> %33, splat (double 0x16687E92154EF7AC)
  %38 = select <8 x i1> %34, <8 x double> %26, <8 x double> zeroinitializer
  %39 = select <8 x i1> %35, <8 x double> %27, <8 x double> zeroinitializer
  %40 = select <8 x i1> %36, <8 x double> %28, <8 x double> zeroinitializer
  %41 = select <8 x i1> %37, <8 x double> %29, <8 x double> zeroinitializer
  store <8 x double> %38, ptr %scevgep13, align 8
  store <8 x double> %39, ptr %scevgep12, align 8
  store <8 x double> %40, ptr %scevgep11, align 8
  store <8 x double> %41, ptr %lsr.iv9, align 8
  %.679.us.us = add nuw nsw i64 %.672512518.us.us, 1
  %scevgep10 = getelementptr i8, ptr %lsr.iv9, i64 %8
  %exitcond559.not = icmp eq i64 %arg.blocks.3.0.2.fr, %.679.us.us
  br i1 %exitcond559.not, label %B196.B142.loopexit_crit_edge.split.us.us, label %B198.endif.endif.us.us

B196.B142.loopexit_crit_edge.split.us.us:         ; preds = %B198.endif.endif.us.us
  %.545.us = add nuw nsw i64 %.538528538.us, 1
  %scevgep8 = getelementptr i8, ptr %lsr.iv, i64 %7
  %exitcond560.not = icmp eq i64 %.545.us, %arg.blocks.1.2
  br i1 %exitcond560.not, label %B372.endif, label %B144.endif.us

B372.endif:                                       ; preds = %B196.B142.loopexit_crit_edge.split.us.us, %B0.endif.endif.endif
  %.1173553.not = icmp slt i64 %arg.blocks.3.0.2.fr, 1
  tail call void @NRT_decref(ptr %arg.blocks.0.0)
  br i1 %.1173553.not, label %B448, label %iter.check

iter.check:                                       ; preds = %B372.endif
  %min.iters.check = icmp samesign ult i64 %arg.blocks.3.0.2.fr, 4
  br i1 %min.iters.check, label %B424.preheader, label %vector.main.loop.iter.check

B424.preheader:                                   ; preds = %vec.epilog.middle.block, %vec.epilog.iter.check, %iter.check
  %.1179552554.ph = phi i64 [ %n.vec28, %vec.epilog.middle.block ], [ %n.vec, %vec.epilog.iter.check ], [ 0, %iter.check ]
  br label %B424

vector.main.loop.iter.check:                      ; preds = %iter.check
  %const27 = bitcast i64 9223372036854775776 to i64
  %min.iters.check21 = icmp samesign ult i64 %arg.blocks.3.0.2.fr, 32
  br i1 %min.iters.check21, label %vec.epilog.ph, label %vector.ph22

vector.ph22:                                      ; preds = %vector.main.loop.iter.check
  %n.vec = and i64 %arg.blocks.3.0.2.fr, %const27
  br label %vector.body23

vector.body23:                                    ; preds = %vector.body23, %vector.ph22
  %index24 = phi i64 [ 0, %vector.ph22 ], [ %index.next25, %vector.body23 ]
  %sunkaddr39 = mul i64 %index24, 8
  %sunkaddr40 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr39
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr40, align 8
  %sunkaddr41 = mul i64 %index24, 8
  %sunkaddr42 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr41
  %sunkaddr43 = getelementptr i8, ptr %sunkaddr42, i64 64
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr43, align 8
  %sunkaddr44 = mul i64 %index24, 8
  %sunkaddr45 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr44
  %sunkaddr46 = getelementptr i8, ptr %sunkaddr45, i64 128
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr46, align 8
  %sunkaddr47 = mul i64 %index24, 8
  %sunkaddr48 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %sunkaddr47
  %sunkaddr49 = getelementptr i8, ptr %sunkaddr48, i64 192
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr49, align 8
  %index.next25 = add nuw nsw i64 %index24, 32
  %42 = icmp eq i64 %n.vec, %index.next25
  br i1 %42, label %middle.block26, label %vector.body23, !llvm.loop !462

middle.block26:                                   ; preds = %vector.body23
  %cmp.n = icmp eq i64 %arg.blocks.3.0.2.fr, %n.vec
  br i1 %cmp.n, label %B448, label %vec.epilog.iter.check

vec.epilog.iter.check:                            ; preds = %middle.block26
  %n.mod.vf = and i64 %arg.blocks.3.0.2.fr, 28
  %min.epilog.iters.check = icmp eq i64 %n.mod.vf, 0
  br i1 %min.epilog.iters.check, label %B424.preheader, label %vec.epilog.ph, !prof !91

vec.epilog.ph:                                    ; preds = %vec.epilog.iter.check, %vector.main.loop.iter.check
  %vec.epilog.resume.val = phi i64 [ %n.vec, %vec.epilog.iter.check ], [ 0, %vector.main.loop.iter.check ]
  %const_mat28 = add i64 %const27, 28
  %n.vec28 = and i64 %arg.blocks.3.0.2.fr, %const_mat28
  br label %vec.epilog.vector.body

vec.epilog.vector.body:                           ; preds = %vec.epilog.vector.body, %vec.epilog.ph
  %index29 = phi i64 [ %vec.epilog.resume.val, %vec.epilog.ph ], [ %index.next30, %vec.epilog.vector.body ]
  %43 = shl i64 %index29, 3
  %scevgep1 = getelementptr i8, ptr %arg.blocks.3.0.4, i64 %43
  store <4 x double> splat (double 1.000000e+00), ptr %scevgep1, align 8
  %index.next30 = add nuw i64 %index29, 4
  %44 = icmp eq i64 %n.vec28, %index.next30
  br i1 %44, label %vec.epilog.middle.block, label %vec.epilog.vector.body, !llvm.loop !463

vec.epilog.middle.block:                          ; preds = %vec.epilog.vector.body
  %cmp.n31 = icmp eq i64 %arg.blocks.3.0.2.fr, %n.vec28
  br i1 %cmp.n31, label %B448, label %B424.preheader
}

attributes #0 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #1 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #2 = { mustprogress nofree noinline norecurse nounwind willreturn memory(argmem: readwrite) }
attributes #3 = { noinline }
attributes #4 = { mustprogress nocallback nofree nosync nounwind willreturn memory(inaccessiblemem: write) }
attributes #5 = { nounwind }
attributes #6 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: write) }
attributes #7 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #8 = { mustprogress nocallback nofree nosync nounwind willreturn memory(none) }
attributes #9 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #10 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #11 = { nofree norecurse nosync nounwind memory(write, argmem: readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #12 = { nofree nounwind memory(read) }
attributes #13 = { mustprogress nocallback nofree nosync nounwind willreturn memory(write) }
attributes #14 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: read) }
attributes #15 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: write) }

!0 = !{!"branch_weights", i32 49, i32 1}
!1 = !{!"branch_weights", i32 1, i32 49, i32 49}
!2 = !{!3}
!3 = distinct !{!3, !4, !"_ZN18elastomer_friction7kernels5scene6follow11first_afterB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx: %retptr"}
!4 = distinct !{!4, !"_ZN18elastomer_friction7kernels5scene6follow11first_afterB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx"}
!5 = !{!6}
!6 = distinct !{!6, !7, !"_ZN18elastomer_friction7kernels5scene6follow11first_afterB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx: %retptr"}
!7 = distinct !{!7, !"_ZN18elastomer_friction7kernels5scene6follow11first_afterB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx"}
!8 = !{!9}
!9 = distinct !{!9, !10, !"_ZN18elastomer_friction7kernels5scene6follow7seen_atB3v58B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29xx: %retptr"}
!10 = distinct !{!10, !"_ZN18elastomer_friction7kernels5scene6follow7seen_atB3v58B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29xx"}
!11 = !{!"branch_weights", i32 1, i32 99}
!12 = !{!"branch_weights", i32 99, i32 1}
!13 = !{!"branch_weights", i32 199, i32 9801}
!14 = !{!"branch_weights", i32 33554432, i32 -973078528}
!15 = !{!"branch_weights", i32 -939524096, i32 0}
!16 = !{!"branch_weights", i32 21474837, i32 2126008811}
!17 = !{!18, !20, !21, !23, !24, !26}
!18 = distinct !{!18, !19, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!19 = distinct !{!19, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!20 = distinct !{!20, !19, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!21 = distinct !{!21, !22, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!22 = distinct !{!22, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!23 = distinct !{!23, !22, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!24 = distinct !{!24, !25, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v3B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE48omitted_28default_3d_3cclass_20_27float_27_3e_29: %retptr"}
!25 = distinct !{!25, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v3B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE48omitted_28default_3d_3cclass_20_27float_27_3e_29"}
!26 = distinct !{!26, !25, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v3B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE48omitted_28default_3d_3cclass_20_27float_27_3e_29: %excinfo"}
!27 = !{!24, !26}
!28 = !{!29, !31, !32, !34, !35, !37}
!29 = distinct !{!29, !30, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!30 = distinct !{!30, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!31 = distinct !{!31, !30, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!32 = distinct !{!32, !33, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!33 = distinct !{!33, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!34 = distinct !{!34, !33, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!35 = distinct !{!35, !36, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %retptr"}
!36 = distinct !{!36, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29"}
!37 = distinct !{!37, !36, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %excinfo"}
!38 = !{!35, !37}
!39 = !{!40, !42, !43, !45, !46, !48}
!40 = distinct !{!40, !41, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!41 = distinct !{!41, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!42 = distinct !{!42, !41, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!43 = distinct !{!43, !44, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!44 = distinct !{!44, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!45 = distinct !{!45, !44, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!46 = distinct !{!46, !47, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %retptr"}
!47 = distinct !{!47, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29"}
!48 = distinct !{!48, !47, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %excinfo"}
!49 = !{!46, !48}
!50 = !{!51, !53, !54, !56, !57, !59}
!51 = distinct !{!51, !52, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!52 = distinct !{!52, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!53 = distinct !{!53, !52, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!54 = distinct !{!54, !55, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!55 = distinct !{!55, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!56 = distinct !{!56, !55, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!57 = distinct !{!57, !58, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v7B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx16class_28int64_29: %retptr"}
!58 = distinct !{!58, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v7B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx16class_28int64_29"}
!59 = distinct !{!59, !58, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v7B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx16class_28int64_29: %excinfo"}
!60 = !{!57, !59}
!61 = !{!62, !64, !65, !67, !68, !70}
!62 = distinct !{!62, !63, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!63 = distinct !{!63, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!64 = distinct !{!64, !63, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!65 = distinct !{!65, !66, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!66 = distinct !{!66, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!67 = distinct !{!67, !66, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!68 = distinct !{!68, !69, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %retptr"}
!69 = distinct !{!69, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29"}
!70 = distinct !{!70, !69, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %excinfo"}
!71 = !{!68, !70}
!72 = !{!73, !75, !76, !78, !79, !81, !82, !84}
!73 = distinct !{!73, !74, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!74 = distinct !{!74, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!75 = distinct !{!75, !74, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!76 = distinct !{!76, !77, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!77 = distinct !{!77, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!78 = distinct !{!78, !77, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!79 = distinct !{!79, !80, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v10B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx18class_28float64_29: %retptr"}
!80 = distinct !{!80, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v10B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx18class_28float64_29"}
!81 = distinct !{!81, !80, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v10B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx18class_28float64_29: %excinfo"}
!82 = distinct !{!82, !83, !"_ZN5numba2np8arrayobj12impl_np_full12_3clocals_3e4fullB2v9B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dExd27omitted_28default_3dNone_29: %retptr"}
!83 = distinct !{!83, !"_ZN5numba2np8arrayobj12impl_np_full12_3clocals_3e4fullB2v9B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dExd27omitted_28default_3dNone_29"}
!84 = distinct !{!84, !83, !"_ZN5numba2np8arrayobj12impl_np_full12_3clocals_3e4fullB2v9B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dExd27omitted_28default_3dNone_29: %excinfo"}
!85 = !{!82, !84}
!86 = distinct !{!86, !87, !88}
!87 = !{!"llvm.loop.unroll.runtime.disable"}
!88 = !{!"llvm.loop.isvectorized", i32 1}
!89 = !{!79, !81, !82, !84}
!90 = distinct !{!90, !88, !87}
!91 = !{!"branch_weights", i32 4, i32 28}
!92 = distinct !{!92, !88, !87}
!93 = distinct !{!93, !94}
!94 = !{!"llvm.loop.unroll.disable"}
!95 = distinct !{!95, !94}
!96 = !{!97, !99, !100, !102, !103, !105}
!97 = distinct !{!97, !98, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!98 = distinct !{!98, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!99 = distinct !{!99, !98, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!100 = distinct !{!100, !101, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!101 = distinct !{!101, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!102 = distinct !{!102, !101, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!103 = distinct !{!103, !104, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %retptr"}
!104 = distinct !{!104, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29"}
!105 = distinct !{!105, !104, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %excinfo"}
!106 = !{!"branch_weights", i32 146201250, i32 2001282398}
!107 = !{!"branch_weights", i32 127, i32 1}
!108 = !{!109}
!109 = distinct !{!109, !110, !"_ZN5numba2np9arraymath9array_sum12_3clocals_3e14array_sum_implB3v25B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE27omitted_28default_3dNone_2927omitted_28default_3dNone_29: %retptr"}
!110 = distinct !{!110, !"_ZN5numba2np9arraymath9array_sum12_3clocals_3e14array_sum_implB3v25B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE27omitted_28default_3dNone_2927omitted_28default_3dNone_29"}
!111 = !{!"branch_weights", i32 1, i32 1}
!112 = distinct !{!112, !94}
!113 = !{!"branch_weights", i32 -2147483648, i32 0}
!114 = !{!"branch_weights", i32 277993707, i32 1869489941}
!115 = !{!"branch_weights", i32 542333185, i32 1605150463}
!116 = distinct !{!116, !117, !94}
!117 = !{!"llvm.loop.estimated_trip_count", i32 4}
!118 = !{!"branch_weights", i32 166258294, i32 1981225354}
!119 = distinct !{!119, !120}
!120 = !{!"llvm.loop.estimated_trip_count", i32 3}
!121 = !{!103, !105}
!122 = !{!123, !125, !126, !128, !129, !131}
!123 = distinct !{!123, !124, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!124 = distinct !{!124, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!125 = distinct !{!125, !124, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!126 = distinct !{!126, !127, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!127 = distinct !{!127, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!128 = distinct !{!128, !127, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!129 = distinct !{!129, !130, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %retptr"}
!130 = distinct !{!130, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29"}
!131 = distinct !{!131, !130, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %excinfo"}
!132 = !{!129, !131}
!133 = !{!134, !136, !137, !139, !140, !142}
!134 = distinct !{!134, !135, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!135 = distinct !{!135, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!136 = distinct !{!136, !135, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!137 = distinct !{!137, !138, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!138 = distinct !{!138, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!139 = distinct !{!139, !138, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!140 = distinct !{!140, !141, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %retptr"}
!141 = distinct !{!141, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29"}
!142 = distinct !{!142, !141, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %excinfo"}
!143 = !{!140, !142}
!144 = !{!145, !147, !148, !150, !151, !153}
!145 = distinct !{!145, !146, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!146 = distinct !{!146, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!147 = distinct !{!147, !146, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!148 = distinct !{!148, !149, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!149 = distinct !{!149, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!150 = distinct !{!150, !149, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!151 = distinct !{!151, !152, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %retptr"}
!152 = distinct !{!152, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29"}
!153 = distinct !{!153, !152, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %excinfo"}
!154 = !{!151, !153}
!155 = !{!156, !158, !159, !161, !162, !164}
!156 = distinct !{!156, !157, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!157 = distinct !{!157, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!158 = distinct !{!158, !157, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!159 = distinct !{!159, !160, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!160 = distinct !{!160, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!161 = distinct !{!161, !160, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!162 = distinct !{!162, !163, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %retptr"}
!163 = distinct !{!163, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29"}
!164 = distinct !{!164, !163, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx48omitted_28default_3d_3cclass_20_27float_27_3e_29: %excinfo"}
!165 = !{!162, !164}
!166 = !{!167, !169, !170, !172}
!167 = distinct !{!167, !168, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!168 = distinct !{!168, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!169 = distinct !{!169, !168, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!170 = distinct !{!170, !171, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!171 = distinct !{!171, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!172 = distinct !{!172, !171, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!173 = distinct !{!173, !88, !87}
!174 = distinct !{!174, !94}
!175 = distinct !{!175, !88}
!176 = !{!"branch_weights", i32 0, i32 -2147483648}
!177 = !{!178}
!178 = distinct !{!178, !179, !"_ZN5numba2np9arraymath9array_sum12_3clocals_3e14array_sum_implB3v25B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE27omitted_28default_3dNone_2927omitted_28default_3dNone_29: %retptr"}
!179 = distinct !{!179, !"_ZN5numba2np9arraymath9array_sum12_3clocals_3e14array_sum_implB3v25B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE27omitted_28default_3dNone_2927omitted_28default_3dNone_29"}
!180 = distinct !{!180, !94}
!181 = distinct !{!181, !120}
!182 = !{!183, !185, !186, !188}
!183 = distinct !{!183, !184, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!184 = distinct !{!184, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!185 = distinct !{!185, !184, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!186 = distinct !{!186, !187, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!187 = distinct !{!187, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!188 = distinct !{!188, !187, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!189 = distinct !{!189, !88, !87}
!190 = distinct !{!190, !88, !87}
!191 = distinct !{!191, !94}
!192 = distinct !{!192, !88}
!193 = !{!194}
!194 = distinct !{!194, !195}
!195 = distinct !{!195, !"LVerDomain"}
!196 = !{!197}
!197 = distinct !{!197, !195}
!198 = distinct !{!198, !88, !87}
!199 = distinct !{!199, !88, !87}
!200 = distinct !{!200, !94}
!201 = distinct !{!201, !88}
!202 = distinct !{!202, !88, !87}
!203 = distinct !{!203, !88, !87}
!204 = distinct !{!204, !87, !88}
!205 = !{!206}
!206 = distinct !{!206, !207, !"_ZN5numba2np9arraymath9array_sum12_3clocals_3e14array_sum_implB3v25B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE27omitted_28default_3dNone_2927omitted_28default_3dNone_29: %retptr"}
!207 = distinct !{!207, !"_ZN5numba2np9arraymath9array_sum12_3clocals_3e14array_sum_implB3v25B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE27omitted_28default_3dNone_2927omitted_28default_3dNone_29"}
!208 = distinct !{!208, !94}
!209 = distinct !{!209, !120}
!210 = !{!"branch_weights", i32 1, i32 127}
!211 = !{!212}
!212 = distinct !{!212, !213, !"_ZN5numba2np9arraymath9array_sum12_3clocals_3e14array_sum_implB3v25B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE27omitted_28default_3dNone_2927omitted_28default_3dNone_29: %retptr"}
!213 = distinct !{!213, !"_ZN5numba2np9arraymath9array_sum12_3clocals_3e14array_sum_implB3v25B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi1E1C7mutable7alignedE27omitted_28default_3dNone_2927omitted_28default_3dNone_29"}
!214 = distinct !{!214, !94}
!215 = distinct !{!215, !120}
!216 = !{i1 true}
!217 = !{!"branch_weights", i32 127, i32 12545}
!218 = !{!219, !221}
!219 = distinct !{!219, !220, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29: %retptr"}
!220 = distinct !{!220, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29"}
!221 = distinct !{!221, !220, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29: %excinfo"}
!222 = !{!223, !225, !219, !221}
!223 = distinct !{!223, !224, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE: %retptr"}
!224 = distinct !{!224, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE"}
!225 = distinct !{!225, !224, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE: %excinfo"}
!226 = !{!227, !229, !230, !232, !233, !235}
!227 = distinct !{!227, !228, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v37B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29: %retptr"}
!228 = distinct !{!228, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v37B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29"}
!229 = distinct !{!229, !228, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v37B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29: %excinfo"}
!230 = distinct !{!230, !231, !"_ZN5numba2np9arraymath7npy_min12_3clocals_3e8impl_minB3v34B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!231 = distinct !{!231, !"_ZN5numba2np9arraymath7npy_min12_3clocals_3e8impl_minB3v34B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!232 = distinct !{!232, !231, !"_ZN5numba2np9arraymath7npy_min12_3clocals_3e8impl_minB3v34B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!233 = distinct !{!233, !234, !"_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!234 = distinct !{!234, !"_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE"}
!235 = distinct !{!235, !234, !"_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!236 = !{!237, !239, !227, !229, !230, !232, !233, !235}
!237 = distinct !{!237, !238, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE: %retptr"}
!238 = distinct !{!238, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE"}
!239 = distinct !{!239, !238, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE: %excinfo"}
!240 = !{!230, !232, !233, !235}
!241 = !{!"branch_weights", i32 129, i32 127}
!242 = !{!243, !245, !246, !248, !249, !251}
!243 = distinct !{!243, !244, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v37B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29: %retptr"}
!244 = distinct !{!244, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v37B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29"}
!245 = distinct !{!245, !244, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v37B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29: %excinfo"}
!246 = distinct !{!246, !247, !"_ZN5numba2np9arraymath7npy_min12_3clocals_3e8impl_minB3v34B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!247 = distinct !{!247, !"_ZN5numba2np9arraymath7npy_min12_3clocals_3e8impl_minB3v34B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!248 = distinct !{!248, !247, !"_ZN5numba2np9arraymath7npy_min12_3clocals_3e8impl_minB3v34B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!249 = distinct !{!249, !250, !"_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!250 = distinct !{!250, !"_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE"}
!251 = distinct !{!251, !250, !"_ZN18elastomer_friction7kernels5scene12march_blocks8cap_overB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!252 = !{!253, !255, !243, !245, !246, !248, !249, !251}
!253 = distinct !{!253, !254, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE: %retptr"}
!254 = distinct !{!254, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE"}
!255 = distinct !{!255, !254, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE: %excinfo"}
!256 = !{!246, !248, !249, !251}
!257 = !{!258}
!258 = distinct !{!258, !259, !"_ZN18elastomer_friction7kernels8rheology6scaled10look_aheadB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29: %retptr"}
!259 = distinct !{!259, !"_ZN18elastomer_friction7kernels8rheology6scaled10look_aheadB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29"}
!260 = distinct !{!260, !88, !87}
!261 = distinct !{!261, !88, !87}
!262 = distinct !{!262, !94}
!263 = distinct !{!263, !88}
!264 = distinct !{!264, !94}
!265 = distinct !{!265, !94}
!266 = !{!267, !269}
!267 = distinct !{!267, !268, !"_ZN18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx: %retptr"}
!268 = distinct !{!268, !"_ZN18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx"}
!269 = distinct !{!269, !268, !"_ZN18elastomer_friction7kernels5model5force13_balance_rowsB3v48B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE34ConstantForce_28float64_20x_201_29161Prony_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20float64_29127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dx: %excinfo"}
!270 = distinct !{!270, !88}
!271 = !{!272}
!272 = distinct !{!272, !273, !"_ZN18elastomer_friction7kernels8rheology6scaled11all_settledB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29: %retptr"}
!273 = distinct !{!273, !"_ZN18elastomer_friction7kernels8rheology6scaled11all_settledB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE236Scales_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29"}
!274 = distinct !{!274, !88, !87}
!275 = distinct !{!275, !88, !87}
!276 = distinct !{!276, !94}
!277 = distinct !{!277, !88}
!278 = !{!279, !281}
!279 = distinct !{!279, !280, !"_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd: %retptr"}
!280 = distinct !{!280, !"_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd"}
!281 = distinct !{!281, !280, !"_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd: %excinfo"}
!282 = !{!283, !285}
!283 = distinct !{!283, !284, !"_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd: %retptr"}
!284 = distinct !{!284, !"_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd"}
!285 = distinct !{!285, !284, !"_ZN18elastomer_friction7kernels5model7contact22_excess_of_spring_rowsB3v50B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE127SpringRows_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29dd: %excinfo"}
!286 = distinct !{!286, !287}
!287 = !{!"llvm.loop.peeled.count", i32 1}
!288 = distinct !{!288, !87, !88}
!289 = !{!290}
!290 = distinct !{!290, !291}
!291 = distinct !{!291, !"LVerDomain"}
!292 = !{!293}
!293 = distinct !{!293, !291}
!294 = distinct !{!294, !88, !87}
!295 = !{!"branch_weights", i32 8, i32 24}
!296 = distinct !{!296, !88, !87}
!297 = distinct !{!297, !94}
!298 = distinct !{!298, !88}
!299 = distinct !{!299, !88, !87}
!300 = distinct !{!300, !88, !87}
!301 = !{!302, !304}
!302 = distinct !{!302, !303, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29: %retptr"}
!303 = distinct !{!303, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29"}
!304 = distinct !{!304, !303, !"_ZN5numba2np8arrayobj10numpy_take12_3clocals_3e9take_implB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi0E1C7mutable7alignedEx27omitted_28default_3dNone_29: %excinfo"}
!305 = !{!306, !308, !302, !304}
!306 = distinct !{!306, !307, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE: %retptr"}
!307 = distinct !{!307, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE"}
!308 = distinct !{!308, !307, !"_ZN5numba2np8arrayobj11array_ravel12_3clocals_3e10imp_nocopyB3v20B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIdLi0E1C7mutable7alignedE: %excinfo"}
!309 = distinct !{!309, !94}
!310 = distinct !{!310, !88}
!311 = !{!312}
!312 = distinct !{!312, !313, !"_ZN18elastomer_friction7kernels8rheology6scaled8_predictB3v46B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!313 = distinct !{!313, !"_ZN18elastomer_friction7kernels8rheology6scaled8_predictB3v46B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!314 = distinct !{!314, !88}
!315 = !{!316}
!316 = distinct !{!316, !317}
!317 = distinct !{!317, !"LVerDomain"}
!318 = !{!319}
!319 = distinct !{!319, !317}
!320 = !{!316, !312}
!321 = distinct !{!321, !88}
!322 = distinct !{!322, !87, !88}
!323 = distinct !{!323, !94}
!324 = distinct !{!324, !94}
!325 = !{!326}
!326 = distinct !{!326, !327}
!327 = distinct !{!327, !"LVerDomain"}
!328 = !{!329}
!329 = distinct !{!329, !327}
!330 = !{!326, !331}
!331 = distinct !{!331, !327}
!332 = !{!331}
!333 = distinct !{!333, !88, !87}
!334 = distinct !{!334, !88, !87}
!335 = distinct !{!335, !94}
!336 = distinct !{!336, !88, !87}
!337 = distinct !{!337, !88, !87}
!338 = distinct !{!338, !88}
!339 = !{!340}
!340 = distinct !{!340, !341}
!341 = distinct !{!341, !"LVerDomain"}
!342 = !{!343}
!343 = distinct !{!343, !341}
!344 = !{!345}
!345 = distinct !{!345, !346}
!346 = distinct !{!346, !"LVerDomain"}
!347 = !{!348}
!348 = distinct !{!348, !346}
!349 = !{!350}
!350 = distinct !{!350, !346}
!351 = !{!352, !353, !354, !345, !348, !355, !356}
!352 = distinct !{!352, !346}
!353 = distinct !{!353, !346}
!354 = distinct !{!354, !346}
!355 = distinct !{!355, !346}
!356 = distinct !{!356, !346}
!357 = !{!358}
!358 = distinct !{!358, !346}
!359 = !{!350, !352, !353, !354, !345, !348, !355, !356}
!360 = !{!352}
!361 = !{!353, !354, !345, !348, !355, !356}
!362 = !{!355}
!363 = !{!353}
!364 = !{!354, !345, !348, !355, !356}
!365 = !{!356}
!366 = !{!354}
!367 = !{!345, !348, !355, !356}
!368 = distinct !{!368, !88, !87}
!369 = distinct !{!369, !88}
!370 = !{!371}
!371 = distinct !{!371, !372, !"_ZN18elastomer_friction7kernels5scene7records11keep_forcesB3v67B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29xd8UniTupleIdLi3EExdd: %retptr"}
!372 = distinct !{!372, !"_ZN18elastomer_friction7kernels5scene7records11keep_forcesB3v67B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29xd8UniTupleIdLi3EExdd"}
!373 = !{!374}
!374 = distinct !{!374, !375, !"_ZN18elastomer_friction7kernels5scene7records11keep_motionB3v68B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29xd274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29x: %retptr"}
!375 = distinct !{!375, !"_ZN18elastomer_friction7kernels5scene7records11keep_motionB3v68B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE52Trace_28array_28float64_2c_201d_2c_20C_29_20x_208_29xd274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29x"}
!376 = !{!377}
!377 = distinct !{!377, !378, !"_ZN18elastomer_friction7kernels5scene6follow7seen_atB3v58B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29xx: %retptr"}
!378 = distinct !{!378, !"_ZN18elastomer_friction7kernels5scene6follow7seen_atB3v58B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29xx"}
!379 = distinct !{!379, !88}
!380 = !{!381, !383}
!381 = distinct !{!381, !382, !"_ZN5numba2np8arrayobj23normalize_reshape_valueB3v66B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEy5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!382 = distinct !{!382, !"_ZN5numba2np8arrayobj23normalize_reshape_valueB3v66B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEy5ArrayIxLi1E1C7mutable7alignedE"}
!383 = distinct !{!383, !382, !"_ZN5numba2np8arrayobj23normalize_reshape_valueB3v66B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEy5ArrayIxLi1E1C7mutable7alignedE: %excinfo"}
!384 = !{!385}
!385 = distinct !{!385, !386, !"_ZN18elastomer_friction7kernels5scene6follow7seen_atB3v58B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29xx: %retptr"}
!386 = distinct !{!386, !"_ZN18elastomer_friction7kernels5scene6follow7seen_atB3v58B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE274Track_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29xx"}
!387 = !{!388, !390, !391, !393, !394, !396, !397, !399}
!388 = distinct !{!388, !389, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!389 = distinct !{!389, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!390 = distinct !{!390, !389, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!391 = distinct !{!391, !392, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!392 = distinct !{!392, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!393 = distinct !{!393, !392, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!394 = distinct !{!394, !395, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v63B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE39Function_28_3cclass_20_27float_27_3e_29: %retptr"}
!395 = distinct !{!395, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v63B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE39Function_28_3cclass_20_27float_27_3e_29"}
!396 = distinct !{!396, !395, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v63B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE39Function_28_3cclass_20_27float_27_3e_29: %excinfo"}
!397 = distinct !{!397, !398, !"_ZN5numba2np8arrayobj11ol_np_zeros12_3clocals_3e4implB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE48omitted_28default_3d_3cclass_20_27float_27_3e_29: %retptr"}
!398 = distinct !{!398, !"_ZN5numba2np8arrayobj11ol_np_zeros12_3clocals_3e4implB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE48omitted_28default_3d_3cclass_20_27float_27_3e_29"}
!399 = distinct !{!399, !398, !"_ZN5numba2np8arrayobj11ol_np_zeros12_3clocals_3e4implB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE48omitted_28default_3d_3cclass_20_27float_27_3e_29: %excinfo"}
!400 = !{!394, !396, !397, !399}
!401 = !{!402, !397, !399}
!402 = distinct !{!402, !403, !"_ZN5numba2np8arrayobj18ol_array_zero_fill12_3clocals_3e4implB3v64B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!403 = distinct !{!403, !"_ZN5numba2np8arrayobj18ol_array_zero_fill12_3clocals_3e4implB3v64B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi2E1C7mutable7alignedE"}
!404 = !{!405, !407, !408, !410, !411, !413, !414, !416}
!405 = distinct !{!405, !406, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!406 = distinct !{!406, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!407 = distinct !{!407, !406, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!408 = distinct !{!408, !409, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!409 = distinct !{!409, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!410 = distinct !{!410, !409, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!411 = distinct !{!411, !412, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v63B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE39Function_28_3cclass_20_27float_27_3e_29: %retptr"}
!412 = distinct !{!412, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v63B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE39Function_28_3cclass_20_27float_27_3e_29"}
!413 = distinct !{!413, !412, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v63B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE39Function_28_3cclass_20_27float_27_3e_29: %excinfo"}
!414 = distinct !{!414, !415, !"_ZN5numba2np8arrayobj11ol_np_zeros12_3clocals_3e4implB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE48omitted_28default_3d_3cclass_20_27float_27_3e_29: %retptr"}
!415 = distinct !{!415, !"_ZN5numba2np8arrayobj11ol_np_zeros12_3clocals_3e4implB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE48omitted_28default_3d_3cclass_20_27float_27_3e_29"}
!416 = distinct !{!416, !415, !"_ZN5numba2np8arrayobj11ol_np_zeros12_3clocals_3e4implB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE8UniTupleIxLi2EE48omitted_28default_3d_3cclass_20_27float_27_3e_29: %excinfo"}
!417 = !{!411, !413, !414, !416}
!418 = !{!419, !414, !416}
!419 = distinct !{!419, !420, !"_ZN5numba2np8arrayobj18ol_array_zero_fill12_3clocals_3e4implB3v64B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!420 = distinct !{!420, !"_ZN5numba2np8arrayobj18ol_array_zero_fill12_3clocals_3e4implB3v64B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE5ArrayIdLi2E1C7mutable7alignedE"}
!421 = !{!422}
!422 = distinct !{!422, !423}
!423 = distinct !{!423, !"LVerDomain"}
!424 = !{!425}
!425 = distinct !{!425, !423}
!426 = !{!427, !422, !428, !429}
!427 = distinct !{!427, !423}
!428 = distinct !{!428, !423}
!429 = distinct !{!429, !423}
!430 = !{!429}
!431 = !{!428}
!432 = !{!427}
!433 = !{!422, !428, !429}
!434 = distinct !{!434, !88, !87}
!435 = !{!"branch_weights", i32 4, i32 12}
!436 = distinct !{!436, !88, !87}
!437 = distinct !{!437, !94}
!438 = !{!439, !441}
!439 = distinct !{!439, !440, !"_ZN5numba2np8arrayobj23normalize_reshape_valueB3v66B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEy5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!440 = distinct !{!440, !"_ZN5numba2np8arrayobj23normalize_reshape_valueB3v66B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEy5ArrayIxLi1E1C7mutable7alignedE"}
!441 = distinct !{!441, !440, !"_ZN5numba2np8arrayobj23normalize_reshape_valueB3v66B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEy5ArrayIxLi1E1C7mutable7alignedE: %excinfo"}
!442 = distinct !{!442, !94}
!443 = !{!444, !446, !447, !449, !450, !452, !453, !455}
!444 = distinct !{!444, !445, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!445 = distinct !{!445, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!446 = distinct !{!446, !445, !"_ZN5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v5B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!447 = distinct !{!447, !448, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %retptr"}
!448 = distinct !{!448, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj"}
!449 = distinct !{!449, !448, !"_ZN5numba2np8arrayobj15_call_allocatorB2v4B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj: %excinfo"}
!450 = distinct !{!450, !451, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v73B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx16class_28int64_29: %retptr"}
!451 = distinct !{!451, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v73B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx16class_28int64_29"}
!452 = distinct !{!452, !451, !"_ZN5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB3v73B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx16class_28int64_29: %excinfo"}
!453 = distinct !{!453, !454, !"_ZN5numba2np8arrayobj9np_arange12_3clocals_3e4implB3v70B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx27omitted_28default_3dNone_2927omitted_28default_3dNone_2927omitted_28default_3dNone_29: %retptr"}
!454 = distinct !{!454, !"_ZN5numba2np8arrayobj9np_arange12_3clocals_3e4implB3v70B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx27omitted_28default_3dNone_2927omitted_28default_3dNone_2927omitted_28default_3dNone_29"}
!455 = distinct !{!455, !454, !"_ZN5numba2np8arrayobj9np_arange12_3clocals_3e4implB3v70B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx27omitted_28default_3dNone_2927omitted_28default_3dNone_2927omitted_28default_3dNone_29: %excinfo"}
!456 = !{!453, !455}
!457 = distinct !{!457, !87, !88}
!458 = !{!450, !452, !453, !455}
!459 = distinct !{!459, !88, !87}
!460 = distinct !{!460, !88, !87}
!461 = distinct !{!461, !87, !88}
!462 = distinct !{!462, !88, !87}
!463 = distinct !{!463, !88, !87}
