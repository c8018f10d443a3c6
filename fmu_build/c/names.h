/* Names that the linker sees. Where several FMUs are linked into one program, each is compiled with the
   prefix of its standard's functions (FMI 2.0.4, 2.1.1; FMI 3.0.2, 2.5.2), which all others take too. */
#ifndef NAMES_H
#define NAMES_H

#if defined FMI2_FUNCTION_PREFIX
#define OWN_PREFIX FMI2_FUNCTION_PREFIX
#elif defined FMI3_FUNCTION_PREFIX
#define OWN_PREFIX FMI3_FUNCTION_PREFIX
#endif

#ifdef OWN_PREFIX
#define OWN_JOINED(prefix, name) prefix##name
#define OWN_NAME(prefix, name) OWN_JOINED(prefix, name)
#define OWN(name) OWN_NAME(OWN_PREFIX, name)

#define core_advance OWN(core_advance)
#define core_drift OWN(core_drift)
#define core_hold OWN(core_hold)
#define core_initialize OWN(core_initialize)
#define core_is_at OWN(core_is_at)
#define core_next_tick OWN(core_next_tick)
#define core_now OWN(core_now)
#define core_refresh OWN(core_refresh)
#define core_reset OWN(core_reset)
#define core_retune OWN(core_retune)
#define core_settle OWN(core_settle)
#define core_slope OWN(core_slope)
#define core_ticks_before OWN(core_ticks_before)
#define core_touch OWN(core_touch)
#define derivative_adjoint OWN(derivative_adjoint)
#define derivative_directional OWN(derivative_directional)
#define inputs_advance OWN(inputs_advance)
#define inputs_begin OWN(inputs_begin)
#define inputs_end OWN(inputs_end)
#define inputs_set_slopes OWN(inputs_set_slopes)
#define instance_count OWN(instance_count)
#define instance_create OWN(instance_create)
#define instance_discard OWN(instance_discard)
#define instance_enter_initialization OWN(instance_enter_initialization)
#define instance_exit_initialization OWN(instance_exit_initialization)
#define instance_get OWN(instance_get)
#define instance_knows OWN(instance_knows)
#define instance_log OWN(instance_log)
#define instance_may OWN(instance_may)
#define instance_note OWN(instance_note)
#define instance_refuse OWN(instance_refuse)
#define instance_reset OWN(instance_reset)
#define instance_set OWN(instance_set)
#define instance_setup OWN(instance_setup)
#define instance_step OWN(instance_step)
#define instance_terminate OWN(instance_terminate)
#define instance_touch OWN(instance_touch)
#define limits OWN(limits)
#define log_categories OWN(log_categories)
#define model_defaults OWN(model_defaults)
#define model_held OWN(model_held)
#define model_inputs OWN(model_inputs)
#define model_is_finite OWN(model_is_finite)
#define model_outputs OWN(model_outputs)
#define model_parameters OWN(model_parameters)
#define model_start OWN(model_start)
#define model_step OWN(model_step)
#define model_tick OWN(model_tick)
#define model_token OWN(model_token)
#define number_text OWN(number_text)
#define range_text OWN(range_text)
#define snapshot_deserialize OWN(snapshot_deserialize)
#define snapshot_free OWN(snapshot_free)
#define snapshot_restore OWN(snapshot_restore)
#define snapshot_save OWN(snapshot_save)
#define snapshot_serialize OWN(snapshot_serialize)
#define snapshot_size OWN(snapshot_size)
#endif

#endif
