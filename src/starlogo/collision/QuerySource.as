package starlogo.collision
{
    import starlogo.data.textOf;
    import starlogo.engine;
    import starlogo.search.NarrowPhase;

    use namespace engine;

    /**
     * Gives questions the shapes of agents: the base class of a Collision, of the collision systems, and of the shapes of a level.
     *
     * @private
     */
    public class QuerySource
    {
        /** Returns the shapes of agents and their tests. Throws an ArgumentError if they are not the engine's. */
        engine function findNarrowPhase():NarrowPhase
        {
            throw errorAbout(this);
        }

        /** Whether all questions may be asked. The shapes of a level are for rays, places and motions. */
        engine function get isForAllQuestions():Boolean
        {
            return true;
        }

        /** The error about something whose agents questions cannot see. */
        engine static function errorAbout(system:Object):ArgumentError
        {
            return new ArgumentError("questions need a Collision or one of the engine's collision systems, such as new TightestFitCollider(greatLand), not "
                    + textOf(system, "a Collision or a Collider") + "; a SeenAgents may also have a LevelShapes");
        }

        /** The Collision whose ground questions see; null if theirs is one of their own. */
        engine function get collisionOfGround():Collision
        {
            return null;
        }
    }
}
