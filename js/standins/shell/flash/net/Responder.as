package flash.net
{
    /** Does nothing. FlexUnit refers to it. */
    public class Responder
    {
        public function Responder(result:Function, status:Function = null)
        {
        }
    }
}
