package client
{
    import starlogo.collision.Collision;

    /** What the client shows. */
    public interface Show
    {
        /** Its collisions. */
        function get collision():Collision;

        /** What is said of it on the screen. */
        function get caption():String;

        /** How many agents there are. */
        function get agentCount():int;

        /** Moves all for a frame and finds the collisions. */
        function play():void;

        /** Puts what is drawn where the agents are, and the camera. */
        function update():void;

        /** A key goes down. */
        function press(key:uint):void;

        /** A key goes up. */
        function release(key:uint):void;
    }
}
