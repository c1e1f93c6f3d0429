package starlogo.convex
{
    /**
     * Moves the time of a motion towards the time of impact, by conservative advancement (van den Bergen, "Ray casting against general convex objects with
     * application to continuous collision detection", 2004). The distance of two convex shapes is a convex function of the time. So Newton's method
     * from the left never steps over its first zero. A sweep measures the shapes at the motion's time, and asks for the next time, as long as there is
     * one.
     *
     * <p>If the shapes touch across the margins only, one more step leads to where they touch without them. It counts if they still touch there. The gap
     * leaves the margins out. So the steps may pass two shapes that touch across the margins alone, if they part again before the motion ends.</p>
     *
     * <p>Each step shrinks the product of the gap and its slope to at most a quarter, and both are numbers of 53 bits. So AdvancementStep.MAX_STEPS steps are
     * enough. Should rounding need more, the time is that of the last step: the shapes do not touch before, and their gap is at most rounding.</p>
     *
     * @param step what the sweep has found at the motion's time; becomes the next step
     * @param motion receives the time of the next step. If there is none, receives the answer: when the shapes touch, or RelativeMotion.NEVER
     * @return whether there is another step
     * @private
     */
    public function advance(step:AdvancementStep, motion:RelativeMotion):Boolean
    {
        var wasTouching:Boolean = step.marginTouchTime != RelativeMotion.NEVER;
        if (step.isTouching)
        {
            if (wasTouching || motion.time == 0)
            {
                return false;
            }
            step.marginTouchTime = motion.time;
        }
        var next:Number = motion.time + step.gap / step.speed;
        if (wasTouching || !(step.speed > 0 && next > motion.time && next <= motion.latest))
        {
            // the step after a touch has led out of it, or there is none in time
            motion.time = step.marginTouchTime;
            return false;
        }
        motion.time = next;
        step.count++;
        return step.count < AdvancementStep.MAX_STEPS;
    }
}
