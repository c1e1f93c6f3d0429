package client
{
    import starlogo.collision.Collision;

    /** A show of the client: a game or a parade. */
    public interface Show
    {
        /** Its collisions. */
        function get collision():Collision;

        /** The text on the screen. */
        function get caption():String;

        /** The number of agents. */
        function get agentCount():int;

        /** Moves everything by one frame and finds the collisions. */
        function play():void;

        /** Moves the objects to their agents, and the camera. */
        function update():void;

        /** Called when a key goes down. */
        function press(key:uint):void;

        /** Called when a key goes up. */
        function release(key:uint):void;
    }
}
